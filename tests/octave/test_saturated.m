## Controllers that ask for more than their bounds give: they arrive at the reference with and
## without integral, bound or not.

function test_saturated ()
  m = gsmbp_fixture ("saturated");
  t = [0, 1, 100];
  for ki = [0, 1e-9, 1e-3, 20]
    n = gsmbp_set (m, "ki", ki);
    warning ("off", "gsmbp:stiff", "local");
    r = gsmbp_simulate (n, m.initial, t, "input", [1; 0; 0], "rtol", 1e-8);
    early = n.out (t(2), r.x(2,:)', [1; 0; 0]);
    word = sprintf (" (Ki = %g)", ki);
    gsmbp_check (["all were at their bound" word], abs (early - 1) < 0.01);
    gsmbp_check (["all arrive [m]" word], r.x(end,1:7) - 1, 1e-3);
  end
  bounds (m);
  digital ();
end

## far beyond the bound the output is the bound: one part in 1e8 at ten times it
function bounds (m)
  for r = [-1e6, -1, 1, 1e6]
    y = m.out (0, m.initial, [r; 0; 0]);
    gsmbp_check (sprintf ("no output beyond the bound, reference %g", r), abs (y) <= m.par.um);
    gsmbp_check (sprintf ("outputs at the bound, reference %g", r), y - sign (r) * m.par.um, 1e-8);
  end
end

## the same with sampled controllers; the bound is no multiple of the converter's step
function digital ()
  m = gsmbp_fixture ("saturated_digital");
  for ki = [0, 1e-9, 20]
    n = gsmbp_set (m, "ki", ki);
    r = gsmbp_simulate (n, m.initial, [0, 1, 100], "input", [1; 0; 0], "rtol", 1e-8);
    word = sprintf (" (Ki = %g)", ki);
    given = r.samples.v(:,cellfun (@(k) k(1), {m.controllers.outputs}));
    gsmbp_check (["sampled: no output beyond the bound" word], abs (given) <= 1);
    gsmbp_check (["sampled: all were at the bound" word], max (given) == 1);
    gsmbp_check (["sampled: all arrive [m]" word], r.x(end,1:6) - 1, 2e-3);
  end
end
