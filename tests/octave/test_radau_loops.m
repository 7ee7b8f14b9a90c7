## Collocation of Radau and BDF in loops with a stiff spring: steps that the move onto the
## constraints does not make short, errors against dp853, drift.

function test_radau_loops ()
  warning ("off", "gsmbp:stiff", "local");
  m = gsmbp_fixture ("stiff_loop");
  x0 = gsmbp_assemble (m, m.initial, "hold", {"q1", "s"});
  truth (m, x0);
  steps (m, x0);
end

function varargout = radau (m, x0, t, varargin)
  [varargout{1:nargout}] = gsmbp_simulate (m, x0, t, "method", "radau", varargin{:});
end

## swinging of 1.4e4 1/s that is hardly damped
function truth (m, x0)
  t = 0:0.02:0.1;
  exact = gsmbp_simulate (m, x0, t, "rtol", 1e-13);
  for k = 1:4
    r = radau (m, x0, t, "rtol", 10 ^ -(2 * k + 2));
    e(k) = state_gap (r, exact);
  end
  gsmbp_check ("a stiff spring in a loop: error over tolerance, 1e-4 to 1e-10", ...
               e ./ 10 .^ -(4:2:10), 10);
  gsmbp_check ("... drift, m and m/s", [r.stats.drift.phi, r.stats.drift.phidot], 1e-14);
  gsmbp_check (sprintf ("... what the steps missed, %.1e m, is told", ...
                        r.stats.drift.before_projection), ...
               r.stats.drift.before_projection > 0 && r.stats.projections >= r.stats.accepted);
end

## The nearest state in the metric of the masses would make the spring swing anew in every step. How
## many steps one run takes, and its error, change with rounding: by which steps the swinging is
## skipped (0.6 to 60 times the tolerance in neighbouring runs); mean and median hardly do, and a
## method that fails takes ten times as many steps.
function steps (m, x0)
  taken = [];
  for stiffness = [1e9, 1e11]
    hard = gsmbp_set (m, "k", stiffness, "c", stiffness / 1e4);
    exact = radau (hard, x0, 0:0.05:1, "rtol", 1e-10);
    e = [];
    for rtol = 10 .^ -(4:0.5:8)
      r = radau (hard, x0, 0:0.05:1, "rtol", rtol);
      taken(end+1) = r.stats.accepted + r.stats.rejected;
      e(end+1) = state_gap (r, exact) / rtol;
    end
    told = sprintf ("%g N/m, rtol 1e-4 to 1e-8: error over tolerance:", stiffness);
    gsmbp_check ([told " median"], median (e), 5);
    gsmbp_check ([told " largest"], max (e), 100);
  end
  told = sprintf ("1e9 and 1e11 N/m, rtol 1e-4 to 1e-8: steps with those that failed:%s", ...
                  sprintf (" %d", taken));
  gsmbp_check ([told ": mean"], mean (taken), 60);
  gsmbp_check ([told ": most over median"], max (taken) / median (taken), 3);
  for tol = [1e-4, 1e-6]
    b = gsmbp_simulate (hard, x0, 0:0.05:1, "method", "cvode", "rtol", tol);
    tried = b.stats.accepted + b.stats.rejected;
    gsmbp_check (sprintf ("%g N/m, cvode, rtol %g: %d steps, with those that failed", ...
                          stiffness, tol, tried), tried < 800);
    gsmbp_check (sprintf ("%g N/m, cvode, rtol %g: error over tolerance", stiffness, tol), ...
                 state_gap (b, exact) / tol, 100);
  end
  gsmbp_check ("... drift of cvode, m and m/s", [b.stats.drift.phi, b.stats.drift.phidot], 1e-13);
  other = radau (hard, x0, 0:0.05:1, "rtol", rtol, "drift", false);
  gsmbp_check ("the same where drift is not watched", ...
               isequal (other.x, r.x) && other.stats.accepted == r.stats.accepted);
end
