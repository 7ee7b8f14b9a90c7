## x = gsmbp_run (m, t, x0, v): states (rows) at the times t under constant inputs v, Dormand-Prince
## at a tolerance of 1e-13, projected on the loops.

function x = gsmbp_run (m, t, x0, v)
  options = {};
  if (! isempty (v))
    options = {"input", v};
  end
  x = gsmbp_simulate (m, x0, t, "rtol", 1e-13, "atol", 1e-13, options{:}).x;
end
