## Plans within limits through the model: what a device cannot follow is refused, drives as
## quasi-static, axes that arrive together, the least time along a path against an integration in
## the phase plane by way of a place without inertia.

function test_limits ()
  arrive_together ();
  refused ();
  least_time ();
end

function arrive_together ()
  q = [0 1; 0 -0.3; 2 2.05; 1 1];
  limits = {"speed", [1 2 1 1], "acceleration", [4 3 2 1], "jerk", 30};
  [plan, law] = gsmbp_plan ("double_s", q, limits{:});
  gsmbp_check ("axes arrive together", max (abs ([law.T] - law(1).T)), 1e-14);
  f = gsmbp_evaluate (plan, linspace (0, law(1).T, 400), 2);
  over = max (abs (f(:,:,2)), [], 2) ./ [1 2 1 1]' - 1;
  gsmbp_check ("within their speeds and accelerations", max ([over; ...
      max(abs (f(:,:,3)), [], 2) ./ [4 3 2 1]' - 1]) <= 1e-12);
  gsmbp_check ("at their goals", max (abs (f(:,end,1) - q(:,2))), 1e-14);
  line = gsmbp_plan ("trapezoid", q(1:3,:), "speed", 1, "acceleration", 2, "synchronized", "line");
  part = (gsmbp_evaluate (line, 0.4) - q(1:3,1)) ./ diff (q(1:3,:), 1, 2);
  gsmbp_check ("on a straight line", max (abs (part - part(1))), 1e-13);
end

function refused ()
  m = gsmbp_fixture ("limits_arm");
  t = 0:0.01:0.5;
  jumps = gsmbp_plan ("trapezoid", [0 0.5; 0 -0.2], "speed", 2, "acceleration", 8);
  try
    gsmbp_inverse (m, jumps, t);
    said = "";
  catch problem
    said = problem.message;
  end
  wanted = 'acceleration of q\d jumps by .* at t = [\d.]+ s.*motor\d \(dc_motor\)';
  gsmbp_check ("a jump of the acceleration is refused: device, time", ...
               ! isempty (regexp (said, wanted)));
  smooth = gsmbp_plan ("double_s", [0 0.5; 0 -0.2], "speed", 2, "acceleration", 8, "jerk", 100);
  static = gsmbp_inverse (m, smooth, t, "quasistatic", true);
  lastwarn ("");
  pushed = gsmbp_inverse (m, smooth, t, "quasistatic", true, "input", [1; 2]);
  gsmbp_check ("quasi-static with inputs from outside: v is not determined, and said so", ...
               [all(isnan (pushed.v(:))), ! isempty(strfind (lastwarn (), "not determined"))]);
  less = gsmbp_set (m, "motor1_L", 1e-10, "motor2_L", 1e-10);
  exact = gsmbp_inverse (less, smooth, t);
  gsmbp_check ("quasi-static: the voltages without inductance", ...
               max (abs (static.v - exact.v)(:)), 1e-6);
end

function least_time ()
  m = gsmbp_fixture ("limits_arm");
  straight = gsmbp_plan ("table", [0 1], [0.2, 2.6; 0.6, -0.4]);
  against_phase_plane (m, straight, [32; 14], 1);
  bent = gsmbp_plan ("cubic", [0.2 1.6; -2.6 1.1], [0 1], "start", [1; 3], "end", [1.6; 4.2]);
  against_phase_plane (m, bent, [60; 12], 0);
end

function against_phase_plane (m, path, limit, n)
  [~, told] = gsmbp_retime (m, path, "effort", limit, "points", 800, "rtol", 5e-2);
  T = phase_plane (m, path, limit, told.singular);
  gsmbp_check ("places without inertia", numel (told.singular) == n);
  gsmbp_check (sprintf ("least time %.7f s by way of %d places without inertia", T, ...
                        numel (told.singular)), told.T / T - 1, 3e-6);
end

## forwards from the start, backwards from the end, both ways from each place without inertia
function T = phase_plane (m, path, limit, singular)
  c = coefficients (m, path);
  at = @(field, s) ppval (c.(field), s);
  o = odeset ("RelTol", 1e-11, "AbsTol", 1e-12, "MaxStep", 2e-3, "Events", @(t, y) out (y));
  fastest = @(s, v) bound (at, s, v, limit, 1);
  slowest = @(s, v) bound (at, s, v, limit, -1);
  curves = {solved(fastest, [0; 0], 1, o)};
  for s = singular
    [v, u] = passing (c, s, limit);
    d = 1e-5;
    curves{end+1} = solved (slowest, [s - d; v - d * u / v], -1, o);
    curves{end+1} = solved (fastest, [s + d; v + d * u / v], 1, o);
  end
  curves{end+1} = solved (slowest, [1; 0], -1, o);
  T = time_under (curves);
end

function c = coefficients (m, path)
  s = (1 - cos (pi * (0:1500) / 1500)) / 2;
  f = gsmbp_evaluate (path, s, 2);
  for k = 1:numel (s)
    [q, dq, ddq] = deal (f(:,k,1), f(:,k,2), f(:,k,3));
    M = m.mas (0, q);
    g = m.bia (0, q, 0 * q);
    a(:,k) = M * dq;
    b(:,k) = M * ddq + (m.bia (0, q, dq) + m.bia (0, q, -dq)) / 2 - g;
    e(:,k) = g;
    d(:,k) = (m.bia (0, q, dq) - m.bia (0, q, -dq)) / 2;
  end
  c = struct ("a", spline (s, a), "b", spline (s, b), "e", spline (s, e), "d", spline (s, d));
end

function u = bound (at, s, v, limit, sign_)
  [a, rest] = deal (at ("a", s), at ("b", s) * v^2 + at ("d", s) * v + at ("e", s));
  u = sign_ * min ((limit - sign_ * sign (a) .* rest) ./ abs (a));
end

## speed and acceleration in a place where the inertia of a row vanishes and the row holds
function [v, u] = passing (c, s, limit)
  p = @(f, s) ppval (c.(f), s);
  [~, i] = min (abs (p ("a", s)) ./ limit);
  row = @(f, s) p(f, s)(i);
  h = 1e-4;
  rate = @(f) (row (f, s + h) - row (f, s - h)) / (2 * h);
  side = sign (row ("b", s));
  r = roots ([row("b", s), row("d", s), row("e", s) - side * limit(i)]);
  v = max (r(imag (r) == 0));
  u = -(rate ("b") * v^2 + rate ("d") * v + rate ("e")) ...
      / (rate ("a") + 2 * row ("b", s) + row ("d", s) / v);
end

function y = solved (u, start, way, o)
  [t, y] = ode45 (@(t, y) way * [y(2); u(y(1), y(2))], [0 5], start, o);
  y = unique (y(y(:,1) > -1e-3 & y(:,1) < 1 + 1e-3,:), "rows");
  [~, k] = unique (y(:,1));
  y = y(k,:);
end

function [value, stop, way] = out (y)
  [value, stop, way] = deal ([y(1) + 5e-4; 1.0005 - y(1); y(2) + 1e-9], [1; 1; 1], [0; 0; 0]);
end

## the least of the curves, as time from 0 to 1; near the ends v is a root
function T = time_under (curves)
  s = (1 - cos (pi * (0:200000) / 200000)) / 2;
  x = Inf (size (s));
  for c = curves
    y = interp1 (c{1}(:,1), c{1}(:,2).^2, s, "spline", NaN);
    y(s < c{1}(1,1) | s > c{1}(end,1)) = Inf;
    x = min (x, y);
  end
  v = sqrt (max (x, 0));
  T = sum (2 * diff (s) ./ (v(1:end-1) + v(2:end)));
end
