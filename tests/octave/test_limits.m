## Plans within limits through the model: what a device cannot follow is refused, drives as
## quasi-static, axes that arrive together, limits of inputs given in the scene, the least time
## along a path against an integration in the phase plane by way of a place without inertia.

function test_limits ()
  arrive_together ();
  refused ();
  of_the_scene ();
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
  gsmbp_check ("... no violations of what is not determined", isempty (pushed.violations));
  said = gsmbp_complaint (@() gsmbp_inverse (m, smooth, t, "quasistatic", true, "input", [1; 2], ...
                                             "limits", 24));
  gsmbp_check (["... limits of it are refused: " said], ! isempty (strfind (said, ...
      "option limits: the inputs are not determined: the command takes no inputs")));
  above_supply (m, smooth, t);
  less = gsmbp_set (m, "motor1_L", 1e-10, "motor2_L", 1e-10);
  exact = gsmbp_inverse (less, smooth, t);
  gsmbp_check ("quasi-static: the voltages without inductance", ...
               max (abs (static.v - exact.v)(:)), 1e-6);
end

## voltages above what the supply gives: which, when first, what they come to
function above_supply (m, plan, t)
  free = gsmbp_inverse (m, plan, t, "limits", 1000);
  gsmbp_check ("voltages within their limits", isempty (free.violations));
  most = max (abs (free.v), [], 1);
  r = gsmbp_inverse (m, plan, t, "limits", [2 * most(1); 0.6 * most(2)]);
  list = r.violations;
  gsmbp_check ("a voltage above its limit: which", ...
               numel (list) == 1 && strcmp (list.text, "motor2.v"));
  first = find (abs (free.v(:,2)) > 0.6 * most(2), 1);
  gsmbp_check ("... when first, by how much", ...
               [list.time - t(first), list.least + 0.4 * most(2)], 1e-12);
  wanted = 'motor2.v takes -?[\d.]+ V at t = [\d.]+ s to move q2, (below|above) its limit of';
  gsmbp_check (["... said: " list.said], ! isempty (regexp (list.said, wanted)));
  said = gsmbp_complaint (@() gsmbp_inverse (m, plan, t, "limits", [1, 2, 3]));
  gsmbp_check (["limits of another size: " said], ...
               ! isempty (strfind (said, "limits: expected one number, 2 numbers or 2 x 2")));
end

function of_the_scene ()
  m = gsmbp_fixture ("limits_push");
  path = gsmbp_plan ("table", [0 1], [0; 1.5]);
  mass = m.mas (0, 0);
  least = @(push, brake) sqrt (2 * 1.5 * mass * (1 / push + 1 / brake));
  [~, told] = gsmbp_retime (m, path);   # it switches between two points: the error asked for
  gsmbp_check ("least time within the limits of the scene", told.T / least (3, 2) - 1, 3e-7);
  [~, told] = gsmbp_retime (m, path, "input", 6, "rtol", 1e-5);
  gsmbp_check ("... within other limits", told.T / least (6, 6) - 1, 1e-9);
  [~, told] = gsmbp_retime (m, path, "input", Inf, "effort", 1, "rtol", 1e-5);
  gsmbp_check ("... without those of the input", told.T / least (1, 1) - 1, 1e-9);
  plan = gsmbp_plan ("quintic", [0 1.5], [0 1]);
  r = gsmbp_inverse (m, plan, linspace (0, 1, 21));
  gsmbp_check (["inputs above the limits of the scene: " r.violations.said], ...
               numel (r.violations) == 1 && r.violations.least == min ([3 - r.v; r.v + 2]));
  r = gsmbp_inverse (m, plan, linspace (0, 1, 21), "limits", 6);
  gsmbp_check ("... within others", isempty (r.violations));
  bare = m;
  bare.subroutines = setdiff (m.subroutines, "cmd");
  said = gsmbp_complaint (@() gsmbp_inverse (bare, plan, 0.5, "limits", 6));
  gsmbp_check (["limits without a command are refused: " said], ...
               ! isempty (strfind (said, "not determined: no inputs v: made on request")));
  lastwarn ("");
  gsmbp_inverse (bare, plan, 0.5);
  gsmbp_check (["limits of the scene without a command: " lastwarn()], ...
               ! isempty (strfind (lastwarn (), "not compared with the limits of the inputs")));
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
  T = phase_plane (m, path, limit, told.singular, 4000);
  gsmbp_check ("places without inertia", numel (told.singular) == n);
  gsmbp_check (sprintf ("least time %.7f s by way of %d places without inertia", T, ...
                        numel (told.singular)), told.T / T - 1, 1e-6);
end

## The least time by curves in the phase plane: x = s'^2 over theta, s = (1 - cos (theta))/2, in n
## steps of Runge and Kutta: forwards from the start, backwards from the end, both ways from each
## place without inertia.  Twice and four times as many steps change it by 1.5e-7 in all.
function T = phase_plane (m, path, limit, singular, n)
  theta = pi * (0:2*n) / (2*n);   # every second one is a node
  s = (1 - cos (theta)) / 2;
  c = coefficients (m, path, s);
  x = min (way (c, theta, limit, 1, 0, 1, n), way (c, theta, limit, 2*n+1, 0, -1, n));
  for s0 = singular
    [v, u] = passing (m, path, s0, limit);
    k = 2 * floor (acos (1 - 2 * s0) / (2 * pi / (2*n))) + 1;   # the node before
    x = min (x, way (c, theta, limit, k, v^2 + 2*u*(s(k) - s0), -1, n));
    x = min (x, way (c, theta, limit, k + 2, v^2 + 2*u*(s(k+2) - s0), 1, n));
  end
  v = sqrt (max (x, 0));
  T = sum (2 * diff (s(1:2:end)) ./ (v(1:end-1) + v(2:end)));
end

## efforts a*s'' + b*s'^2 + d*s' + e
function c = coefficients (m, path, s)
  f = gsmbp_evaluate (path, s, 2);
  for k = 1:numel (s)
    [q, dq, ddq] = deal (f(:,k,1), f(:,k,2), f(:,k,3));
    M = m.mas (0, q);
    [g, up, down] = deal (m.bia (0, q, 0 * q), m.bia (0, q, dq), m.bia (0, q, -dq));
    c.a(:,k) = M * dq;
    c.b(:,k) = M * ddq + (up + down) / 2 - g;
    c.d(:,k) = (up - down) / 2;
    c.e(:,k) = g;
  end
end

## one curve over the nodes from a node with x0 on, forwards or backwards; Inf where it is not
function x = way (c, theta, limit, from, x0, sign_, n)
  h = sign_ * pi / n;
  x = Inf (1, n + 1);
  at = (from + 1) / 2;
  x(at) = x0;
  [P, Q, R] = bounds (c, theta, limit, sign_);
  rate = @(k, x) sign_ * min (P(:,k) + Q(:,k) * x + R(:,k) * sqrt (max (x, 0)));
  while (at + sign_ >= 1 && at + sign_ <= n + 1)
    k = 2 * at - 1;
    y = x(at);
    k1 = rate (k, y);
    k2 = rate (k + sign_, y + h/2 * k1);
    k3 = rate (k + sign_, y + h/2 * k2);
    k4 = rate (k + 2*sign_, y + h * k3);
    y += h/6 * (k1 + 2*k2 + 2*k3 + k4);
    if (! (y > 0))
      return;
    end
    at += sign_;
    x(at) = y;
  end
end

## what bounds dx/dtheta: sign_ times the least row of P + Q*x + R*sqrt (x)
function [P, Q, R] = bounds (c, theta, limit, sign_)
  by = sin (theta) ./ abs (c.a);
  side = -sign_ * sign (c.a) .* by;
  [P, Q, R] = deal (limit .* by + side .* c.e, side .* c.b, side .* c.d);
end

## speed and acceleration in a place where the inertia of a row vanishes and the row holds
function [v, u] = passing (m, path, s, limit)
  h = 1e-4;
  c = coefficients (m, path, [s - h, s, s + h]);
  [~, i] = min (abs (c.a(:,2)) ./ limit);
  rate = @(f) (c.(f)(i,3) - c.(f)(i,1)) / (2 * h);
  side = sign (c.b(i,2));
  r = roots ([c.b(i,2), c.d(i,2), c.e(i,2) - side * limit(i)]);
  v = max (r(imag (r) == 0));
  u = -(rate ("b") * v^2 + rate ("d") * v + rate ("e")) ...
      / (rate ("a") + 2 * c.b(i,2) + c.d(i,2) / v);
end
