## A coordinate that is driven along a table of points: the natural cubic spline through them, and
## what hangs on it, against a spline and an integrator of Octave.

function test_motion_table ()
  m = gsmbp_fixture ("motion_table");
  t = [-0.1, 0.3, 0.4, 0.5, 0.6, 0.7, 1];
  z = [0, 0, 4, 8, 5, 0, 0] / 100;
  s = natural (t, z);
  s1 = ppder (s);
  s2 = ppder (s1);
  at = [t, 0.05:0.1:0.95, linspace(0, 1, 77)];
  for k = 1:numel (at)
    [phi(k), phit(k), ~, gam(k)] = m.con (at(k), [0; 0], [0; 0]);
  end
  gsmbp_check ("law: through the points", phi(1:numel (t)) + z, 1e-15);
  gsmbp_check ("law: the natural spline", phi + ppval (s, at), 1e-15);
  gsmbp_check ("its rate, at the points, too", phit + ppval (s1, at), 1e-13);
  gsmbp_check ("its acceleration, at the points, too", gam - ppval (s2, at), 1e-11);
  [~, ~, ~, gam] = m.con (-1, [0; 0], [0; 0]);
  [~, ~, ~, gam(2)] = m.con (3, [0; 0], [0; 0]);
  gsmbp_check ("straight before and behind", gam, 1e-11);
  x0 = [ppval(s, 0); 0; ppval(s1, 0); 0];
  f = @(t, x) [x(2); (-20e3 * x(1) - 1500 * x(2)) / 300 - ppval(s2, t)];
  times = 0:0.1:1;
  [~, y] = ode45 (f, times, [0; 0], odeset ("RelTol", 1e-11, "AbsTol", 1e-13));
  for way = {"projection", "partitioning", "kane"}
    r = gsmbp_simulate (m, x0, times, "rtol", 1e-11, "loops", way{1});
    what = ["a run, " way{1}];
    gsmbp_check ([what ": the wheel follows the road"], r.x(:,1)' - ppval (s, times), 1e-9);
    gsmbp_check ([what ": the body, against ode45"], r.x(:,2) - y(:,1), 1e-8);
  end
end

## natural cubic spline: second derivatives from the equations of its C2 joints, solved as a whole
function pp = natural (t, z)
  n = numel (t);
  h = diff (t);
  A = eye (n);
  b = zeros (n, 1);
  for k = 2:n-1
    A(k,k-1:k+1) = [h(k-1), 2 * (h(k-1) + h(k)), h(k)];
    b(k) = 6 * ((z(k+1) - z(k)) / h(k) - (z(k) - z(k-1)) / h(k-1));
  end
  M = (A \ b)';
  c = [diff(M) ./ (6 * h); M(1:n-1) / 2; ...
       diff(z) ./ h - h .* (2 * M(1:n-1) + M(2:n)) / 6; z(1:n-1)]';
  pp = mkpp (t, c);
end
