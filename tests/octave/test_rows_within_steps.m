## Rows within the steps of dp853 are as accurate as the ends of steps where the scene has events,
## those that come and those that do not, in steps that stability bounds: beside radau.

function test_rows_within_steps ()
  warning ("off", "gsmbp:stiff", "local");
  m = gsmbp_fixture ("rows_motor");
  t = 0:0.0125:2;
  for turn = [1000, 0.9]
    n = gsmbp_set (m, "turn", turn);
    g = gsmbp_simulate (n, [0 0 0], t, "input", 9, "rtol", 1e-13, "method", "radau");
    for tol = [1e-6, 1e-8, 1e-10]
      r = gsmbp_simulate (n, [0 0 0], t, "input", 9, "rtol", tol);
      e = gsmbp_ensemble (n, [0 0 0], t, "input", 9, "rtol", tol, "parameters", ...
                          struct ("J", n.par.J * [1, 1.1]));
      what = sprintf ("rows at rtol %g, %d events", tol, numel (g.events.t));
      gsmbp_check (what, worst (r.x, g.x) / tol, 3);
      gsmbp_check ([what ", in lanes"], e.lanes && worst (e.x(:,:,1), g.x) / tol < 3);
    end
  end
end

## beside the largest value of each state
function d = worst (x, y)
  d = max (max (abs (x - y), [], 1) ./ max (abs (y), [], 1));
end
