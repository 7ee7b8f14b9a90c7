## Rolling and other constraints on speeds, and the user's on coordinates: a thin disc in steady
## motion (closed form) and wobbling (Appell's equations), Chaplygin's sleigh (closed form), bead,
## gears and cam.

function test_rolling ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  m = gsmbp_fixture ("rolling_disc");
  gsmbp_check ("rolling: two rows are of speeds", ...
               isequal (m.json.speed_rows(:)', [2, 3]) && m.sizes.nlam == 3);
  steady (m);
  wobble (m);
  sleigh (gsmbp_fixture ("rolling_sleigh"));
  cart (gsmbp_fixture ("rolling_cart"));
  bead (gsmbp_fixture ("rolling_bead"));
end

## The disc: axis k at the angle th from the vertical, e1 horizontal, e2 = up in the disc, e3 = k; w
## = (th', ph' sin(th), spin + ph' cos(th)) in them. Balance of moments about the contact, A = m
## R^2/4, C = m R^2/2:
##   (A + mR^2) w1' = A w2^2 cot(th) - (C + mR^2) w2 w3 - m g R cos(th)
##   A w2' = C w1 w3 - A w1 w2 cot(th),    (C + mR^2) w3' = m R^2 w1 w2
function d = appell (y)
  [M, R, g] = deal (2, 0.25, 9.81);
  [A, C] = deal (M * R ^ 2 / 4, M * R ^ 2 / 2);
  d = [y(2); (A * y(3) ^ 2 * cot(y(1)) - (C + M * R ^ 2) * y(3) * y(4) - M * g * R ...
                * cos(y(1))) / (A + M * R ^ 2); ...
       (C * y(2) * y(4) - A * y(2) * y(3) * cot(y(1))) / A; M * R ^ 2 * y(2) ...
           * y(3) / (C + M * R ^ 2); y(3) / sin(y(1))];
end

## the state of the scene for th, heading 0 (e1 along x), rates w1, w2, w3
function x = disc_state (th, w)
  R = 0.25;
  ## e1, e2, e3 of the disc at heading 0: k tilts from z towards -y
  E = pose_turn (1, th)(1:3, 1:3);
  up = E(:, 2);
  omega = E * w;
  x = [R * up; pose_quaternion(E); cross(omega, R * up); w];
end

## th, w1, w2, w3 and heading of a state
function y = seen (x)
  Q = pose_rotation (x(4:7) / norm (x(4:7)));
  k = Q(:, 3);
  th = acos (k(3));
  e2 = ([0; 0; 1] - k(3) * k) / sin (th);
  e1 = cross (e2, k);
  omega = Q * x(11:13)(:);
  y = [th; e1' * omega; e2' * omega; k' * omega; atan2(e1(2), e1(1))];
end

function steady (m)
  [M, R, g, th, ph] = deal (2, 0.25, 9.81, 1.1, 3);
  w2 = ph * sin (th);
  w3 = (M * R ^ 2 / 4 * w2 ^ 2 * cot (th) - M * g * R * cos (th)) / (1.5 * M * R ^ 2 * w2);
  x0 = disc_state (th, [0; w2; w3]);
  [phi, phit, H] = m.con (0, x0(1:7), x0(8:13));
  gsmbp_check ("rolling: the steady state touches the plane and does not slip", ...
               [phi(1); H * x0(8:13) + phit], 1e-14);
  [~, lam] = m.acc (0, x0, []);
  ## the centre goes round with radius |w3| R/ph: normal force = weight, friction = m v ph
  gsmbp_check ("rolling: normal force in steady motion, N", lam(1) - M * g, 1e-12);
  gsmbp_check ("rolling: friction in steady motion, N", norm (lam(2:3)) - M * R * abs (w3) * ph, ...
               1e-12);
  t = linspace (0, 4 * pi / ph, 41)';
  x = gsmbp_run (m, t, x0, []);
  for i = 1:numel (t)
    y(i, :) = seen (x(i, :)');
  end
  ## the motion is stable: errors grow with time at most
  gsmbp_check ("rolling: steady for two rounds", y(:, 1:4) - [th, 0, w2, w3], 1e-10);
  gsmbp_check ("rolling: heading of the steady motion, rad", sin ((y(:, 5) - ph * t) / 2), 1e-10);
  rho = R * abs (w3) / ph;
  middle = mean (x(1:end-1, 1:2));
  gsmbp_check ("rolling: circle of the centre, m", ...
               hypot (x(:, 1) - middle(1), x(:, 2) - middle(2)) - rho, 1e-9);
end

function wobble (m)
  x0 = disc_state (1.2, [0.5; 1.5; -4]);
  t = linspace (0, 2, 41)';
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-12, "atol", 1e-12);
  for i = 1:numel (t)
    y(i, :) = seen (r.x(i, :)');
    E(i, 1) = sum (m.ene (0, r.x(i, :)')(1:2));
    [phi, phit, H] = m.con (0, r.x(i, 1:7)', r.x(i, 8:13)');
    slip(i, :) = [phi(1), (H * r.x(i, 8:13)' + phit)'];
  end
  ## classical Runge-Kutta, 5e-4 s
  [wanted, s] = deal ([1.2; 0.5; 1.5; -4; 0], 5e-4);
  for i = 2:numel (t)
    z = wanted(:, i - 1);
    for k = 1:round ((t(i) - t(i - 1)) / s)
      k1 = appell (z);
      k2 = appell (z + s / 2 * k1);
      k3 = appell (z + s / 2 * k2);
      k4 = appell (z + s * k3);
      z += s / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    end
    wanted(:, i) = z;
  end
  gsmbp_check ("rolling: wobbling disc against Appell's equations", y(:, 1:4) - wanted(1:4, :)', ...
               1e-9);
  gsmbp_check ("rolling: its heading", sin ((y(:, 5) - wanted(5, :)') / 2), 1e-9);
  gsmbp_check ("rolling: energy over 2 s, relative", E / E(1) - 1, 1e-11);
  gsmbp_check ("rolling: height and slip, m and m/s", slip, 1e-12);
end

## v = V tanh(k t + k0), th' = V sqrt(m/(j + m a^2)) / cosh(k t + k0), k = m a V/(j + m a^2), v
## along the edge
function sleigh (m)
  [M, a, j, V, k0] = deal (3, 0.2, 0.08, 2, -1.5);
  c = (j + M * a ^ 2) / M;
  k = a * V / c;
  t = linspace (0, 2, 41)';
  s = k * t + k0;
  turned = @(s) 2 * atan (tanh (s / 2)) * sqrt (c) / a;
  [v, w] = deal (V * tanh (s), V / sqrt (c) ./ cosh (s));
  x = gsmbp_run (m, t, [0; 0; 0; v(1); 0; w(1)], []);
  gsmbp_check ("sleigh: heading", x(:, 3) - (turned (s) - turned (k0)), 1e-10);
  gsmbp_check ("sleigh: speed along the edge", ...
               x(:, 4) .* cos (x(:, 3)) + x(:, 5) .* sin (x(:, 3)) - v, 1e-10);
  gsmbp_check ("sleigh: rate of turning", x(:, 6) - w, 1e-10);
  gsmbp_check ("sleigh: no speed across the edge, m/s", ...
               x(:, 5) .* cos (x(:, 3)) - x(:, 4) .* sin (x(:, 3)), 1e-14);
  gsmbp_check ("sleigh: one row, of speeds", ...
               isequal (m.json.speed_rows, 1) && isequal (m.multipliers(:)', {"blade"}));
  [ud, lam] = m.acc (0, [0; 0; 0.7; v(1) * cos(0.7); v(1) * sin(0.7); w(1)], []);
  ## force across the edge: m (v w + a w') with w' = -v w a m/(j + m a^2)
  gsmbp_check ("sleigh: force of the blade, N", ...
               lam - M * (v(1) * w(1) - a * a * v(1) * w(1) / c), 1e-13);
end

## bead: x'' (1 + 4 k^2 x^2) = -2 k g x - 4 k^2 x x'^2; gears: (j1 + j2/n^2) q1'' = tau + work of
## the cam's slider s = b cos(q1) + v t
function bead (m)
  [k, b, v, ms] = deal (2, 0.1, 0.2, 1.5);
  t = 0.6;
  [xb, xd, q1, w] = deal (0.4, 1.3, 0.9, 5);
  q = [xb; k * xb^2; q1; -q1 / 3; b * cos(q1) + v * t];
  u = [xd; 2 * k * xb * xd; w; -w / 3; -b * sin(q1) * w + v];
  [phi, phit, H] = m.con (t, q, u);
  gsmbp_check ("constraints of the user: closed", [phi; H * u + phit], 1e-15);
  [ud, lam] = m.acc (t, [q; u], []);
  gsmbp_check ("constraints of the user: bead on a parabola", ...
               ud(1) - (-2 * k * 9.81 * xb - 4 * k^2 * xb * xd^2) / (1 + 4 * k^2 * xb^2), ...
               1e-12);
  sdd = @(alpha) -b * cos (q1) * w ^ 2 - b * sin (q1) * alpha;
  J = 0.01 + 0.04 / 9 + ms * b ^ 2 * sin (q1) ^ 2;
  alpha = (0.3 + b * sin (q1) * ms * (-b * cos (q1) * w ^ 2)) / J;
  gsmbp_check ("constraints of the user: wheel with gear and cam", ...
               ud(3:5) - [alpha; -alpha / 3; sdd(alpha)], 1e-11);
  gsmbp_check ("constraints of the user: force of the cam on its slider, N", ...
               lam(strcmp (m.multipliers, "cam")) - ms * sdd (alpha), 1e-11);
  x = gsmbp_run (m, linspace (t, t + 2, 21), [q; u], []);
  later = linspace (t, t + 2, 21)';
  kept = [x(:, 2) - k * x(:, 1) .^ 2, x(:, 3) + 3 * x(:, 4), ...
          x(:, 5) - b * cos(x(:, 3)) - v * later];
  gsmbp_check ("constraints of the user: kept over 2 s", kept, 1e-12);
  energy = 0.25 * (x(:, 6) .^ 2 + x(:, 7) .^ 2) + 0.5 * 9.81 * x(:, 2);
  gsmbp_check ("constraints of the user: energy of the bead, J", energy - energy(1), 1e-11);
end

## a cart on two wheels: 5 coordinates, of which rolling leaves 2 speeds; what control is told
function cart (m)
  pkg load control
  gsmbp_check ("rolling: Gruebler's count has three rows of each disc", ...
               gsmbp_mobility (m, m.initial).gruebler == -1);
  e = struct ("x", m.initial, "v", [0; 0]);
  said = gsmbp_complaint (@() gsmbp_control (m, e, "lqr", "measured", "head"));
  gsmbp_check ("rolling: control says which coordinates remain", ...
               ! isempty (strfind (said, ["leave 5 coordinates beside 2 speeds; remedy: option " ...
                                          "drop with those that need no control (no rate " ...
                                          "depends on x, y, yaw, ql, qr)"])));
  warning ("off", "gsmbp:dropped", "local");
  said = gsmbp_complaint (@() gsmbp_control (m, e, "lqr", "drop", m.coordinates, "measured", ...
                                             "head"));
  gsmbp_check ("rolling: an output that follows what is dropped is unknown", ...
               ! isempty (strfind (said, "option measured: unknown name \"head\"")));
  ## the heading is the second integral of the difference of the torques: its gain is sqrt(Q/R) = 1,
  ## half of its square by each wheel
  c = gsmbp_control (m, e, "lqr", "drop", {"x", "y", "ql", "qr"});
  gsmbp_check ("rolling: a controller without them", abs (c.K(:,1)) - sqrt (0.5), 1e-12);
end
