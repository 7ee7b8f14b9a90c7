## Rows within the steps of dp853 are as accurate as the ends of steps where the scene has events,
## those that come and those that do not, in steps that stability bounds: beside radau. So they are
## where an input that is a function jumps at one of their times.

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
  warning ("off", "gsmbp:margin", "local");
  jumps (gsmbp_hand ("motor_pendulum"));
end

function jumps (m)
  volts = @(t, x) 5 * (t < 0.3) - 4 * (t >= 0.3);
  g = gsmbp_simulate (m, [0.1 0 0], [0 0.3 1], "input", mkpp ([0 0.3 1], [5; -4]), "rtol", 1e-12);
  for method = {"dp853", "auto"}
    r = gsmbp_simulate (m, [0.1 0 0], [0 0.3 1], "input", volts, "method", method{1});
    gsmbp_check (["a function that jumps at a row, " method{1}], worst (r.x, g.x), 1e-8);
  end
end

## beside the largest value of each state
function d = worst (x, y)
  d = max (max (abs (x - y), [], 1) ./ max (abs (y), [], 1));
end
