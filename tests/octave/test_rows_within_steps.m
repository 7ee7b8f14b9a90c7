## Rows within the steps of dp853 are as accurate as the ends of steps where the scene has events,
## those that come and those that do not, in steps that stability bounds: beside radau. So they are
## where an input that is a function jumps at one of their times. Accelerations in rows within the
## steps of radau, in a loop with a stiff spring, beside dp853.

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
  stiff_springs (gsmbp_fixture ("stiff_loop"));
  warning ("off", "gsmbp:margin", "local");
  jumps (gsmbp_hand ("motor_pendulum"));
end

function stiff_springs (m)
  x0 = gsmbp_assemble (m, m.initial);
  t = [0, 0.5 + (1:60) * 0.00731];
  g = gsmbp_simulate (m, x0, t, "rtol", 1e-10);
  exact = accelerations (m, g);
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-6, "method", "radau");
  d = abs (accelerations (m, r) - exact) ./ max (abs (exact), [], 2);
  gsmbp_check (sprintf ("accelerations by radau: %.1g, the median %.1g", max (d(:)), ...
                        max (median (d, 2))), max (d(:)) < 1 && max (median (d, 2)) < 0.02);
end

## at all times but the first one
function a = accelerations (m, r)
  a = zeros (m.sizes.nu, numel (r.t) - 1);
  for k = 1:columns (a)
    rates = m.rhs (r.t(1+k), r.x(1+k,:)', r.v(1+k,:)');
    a(:,k) = rates(m.sizes.nq+(1:m.sizes.nu));
  end
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
