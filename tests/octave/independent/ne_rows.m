## k = ne_rows (M, Q, U, T): maximal coordinates at the joint state Q, U: six velocities [v of the
## mass centre; w] a body, in world axes.
##
## k.com 3xn, k.R 3x3xn positions and orientations (by recursion from the ground), k.w 3xn, k.v 3xn
## velocities. Every joint compares its two axes: displacement of the child's point in the parent's
## joint axes, and rotation. A tree joint writes six rows:
##   k.J a = k.gamma + k.E ud;
## a loop joint the rows that its freedoms leave: k.L a = k.gamma_loop (k.gap is what is still
## open);
## what is given on the speeds themselves: k.U ud = k.gamma_user (k.U u = k.rate_user, k.gap_user).
## The transposed rows carry the forces on body B by body A: six of every joint, k.E' times them are
## the joint efforts. k.mass (6n x 6n, about the mass centres) and k.force (gravity, gyroscopic
## moments, given forces, springs between points) close Newton and Euler: mass a = force + rows' *
## efforts. k.passive: efforts of joint dampers and springs.
##
## k.wrench{j}, k.wrench{number of joints + l}: what the rows' forces of a joint are as force and
## moment about the child's point, in world axes. k.own{l}: the relative motion of a loop joint (see
## ne_own). Without U (or with U = "still") only positions: com, R, J, E, L, gap, U.

function k = ne_rows (m, q, u, t)
  if (nargin < 4)
    t = 0;
  end
  still = nargin < 3 || strcmp (u, "still");
  n = numel (m.body);
  [nq, nu] = ne_sizes (m);
  first_q = cumsum ([0, nq]);
  first_u = cumsum ([0, nu]);
  if (still)
    u = zeros (sum (nu), 1);
  end
  k = place (m, q, first_q);
  k.J = zeros (6 * n);
  k.E = zeros (6 * n, sum (nu));
  k.bias = zeros (6 * n, 1);
  k.passive = zeros (sum (nu), 1);
  for j = 1:n
    six = 6 * j - (5:-1:0);
    joint = m.joint(j);
    qj = q(first_q(j) + (1:nq(j)));
    uj = u(first_u(j) + (1:nu(j)));
    [~, ~, E, k.bias(six, 1)] = ne_freedom (joint, qj, uj);
    k.E(six, first_u(j) + (1:nu(j))) = E;
    k.J(six, :) = six_rows (k, n, joint);
    own = nu(j) - 3 * (nq(j) > nu(j));    # Euler parameters have no dampers and springs
    k.passive(first_u(j) + (1:own)) = -joint.damping(1:own) .* uj(1:own) ...
        - joint.stiffness(1:own) .* (qj(1:own) - joint.rest(1:own));
    k.wrench{j} = twice (frame_a (k, joint));
  end
  velocity = zeros (6, n);
  if (! still)
    velocity = reshape (k.J \ (k.E * u(:)), 6, n);
  end
  k.v = velocity(1:3, :);
  k.w = velocity(4:6, :);
  k.gamma = zeros (6 * n, 1);
  for j = 1:n * ! still
    six = 6 * j - (5:-1:0);
    k.gamma(six) = k.bias(six) + turning (k, m.joint(j), k.J(six, :) * velocity(:));
  end
  k.L = zeros (0, 6 * n);
  k.gamma_loop = k.gap = zeros (0, 1);
  k.own = {};
  for loop = m.loop
    angle = [];
    if (loop.tracked)
      angle = followed (m, q, first_q, loop);
    end
    [rows, gamma, gap, wrench, k.own{end + 1}] = loop_rows (k, n, loop, velocity(:), angle);
    k.L = [k.L; rows];
    k.gamma_loop = [k.gamma_loop; gamma];
    k.gap = [k.gap; gap];
    k.wrench{end + 1} = wrench;
  end
  k = on_speeds (k, m, q, u, t);
  if (! still)
    k = forces (k, m);
  end
end

## rows of the relative motion at the child's point, in the parent's joint axes: three of
## translation, three of rotation
function rows = six_rows (k, n, joint)
  x = at (k, joint.child, joint.point_b);
  P = frame_a (k, joint);
  rows = zeros (6, 6 * n);
  rows = both (rows, k, joint.child, x, P');
  rows = both (rows, k, joint.parent, x, -P');
end

## rows with those of the velocity of the point x of body b, and of its angular velocity, turned by
## R, in the body's columns
function rows = both (rows, k, b, x, R)
  if (b)
    d = x - k.com(:, b);
    rows(:, 6 * b - (5:-1:0)) = [R, -R * [0, -d(3), d(2); d(3), 0, -d(1); -d(2), d(1), 0]; ...
                                 zeros(3), R];
  end
end

## what these rows give of the accelerations besides the second rates: rows a = second rates + this;
## rate = rows * velocity
function c = turning (k, joint, rate)
  x = at (k, joint.child, joint.point_b);
  P = frame_a (k, joint);
  [wA, centripetal_A] = spin (k, joint.parent, x);
  [~, centripetal_B] = spin (k, joint.child, x);
  c = [P' * (centripetal_A - centripetal_B + 2 * ne_cross(wA, P * rate(1:3))); ...
       P' * ne_cross(wA, P * rate(4:6))];
end

## rows, right-hand side and gap of a loop joint: by its `directions` (points coincide along them),
## or whole by its type
function [rows, gamma, gap, wrench, own] = loop_rows (k, n, joint, velocity, angle)
  own = [];
  if (! isempty (joint.directions))
    xA = at (k, joint.parent, joint.point_a);
    xB = at (k, joint.child, joint.point_b);
    [~, centripetal_A] = spin (k, joint.parent, xA);
    [~, centripetal_B] = spin (k, joint.child, xB);
    rows = joint.directions' ...
        * (point_rows (k, n, joint.child, xB) - point_rows (k, n, joint.parent, xA))(1:3, :);
    gamma = joint.directions' * (centripetal_A - centripetal_B);
    gap = joint.directions' * (xB - xA);
    wrench = [joint.directions; zeros(3, columns (joint.directions))];
    return;
  end
  six = six_rows (k, n, joint);
  P = frame_a (k, joint);
  if (strcmp (joint.type, "rolling"))
    [rows, gamma, gap, wrench] = rolling_rows (k, joint, six, six * velocity);
    wrench = twice (P) * wrench;
    return;
  end
  s = P' * (at (k, joint.child, joint.point_b) - at (k, joint.parent, joint.point_a));
  R = P' * turned (k, joint.child) * joint.frame_b;
  rate = six * velocity;
  rest = turning (k, joint, rate);
  own = struct ("s", s, "R", R, "six", six, "rate", rate, "rest", rest);
  if (strcmp (joint.type, "spherical"))
    joint.orientation = [];               # Euler parameters: never singular
  end
  q = ne_measure (joint, s, R);
  if (! isempty (angle))
    q += 2 * pi * round ((angle - q) / (2 * pi));
  end
  [~, nu] = ne_sizes (joint);
  [~, ~, E] = ne_freedom (joint, q, zeros (nu, 1));
  [s_free, R_free, ~, bias] = ne_freedom (joint, q, E \ rate);
  N = eye (6);
  if (nu > 0)
    N = null (E');
  end
  rows = N' * six;
  gamma = N' * (bias + rest);
  gap = N' * [s - s_free; ne_vector(R * R_free')];
  wrench = twice (P) * N;
end

## The angle of a helical loop joint, turns counted on the straight way from q = 0 (joints without
## Euler parameters).
function angle = followed (m, q, first_q, joint)
  angle = 0;
  for part = 0:1/16:1
    k = place (m, part * q, first_q);
    R = (turned (k, joint.parent) * joint.frame_a)' * turned (k, joint.child) * joint.frame_b;
    angle = ne_measure (setfield (joint, "type", "cylindrical"), zeros (3, 1), R, [0; angle])(2);
  end
end

## A thin disc: its centre is the child's point, its axis the joint's `axis` in the child, its plane
## goes through the parent's point with the joint's `second` for normal, all in the joint axes. The
## point r from the centre that touches does not slip (three rows), and is not off the plane (gap).
function [rows, gamma, gap, wrench] = rolling_rows (k, joint, six, rate)
  P = frame_a (k, joint);
  n = joint.second;
  a = P' * turned (k, joint.child) * joint.frame_b * joint.axis;
  w = rate(4:6);
  s = sqrt (1 - (n' * a) ^ 2);
  r = -joint.radius / s * (n - (n' * a) * a);
  ad = ne_cross (w, a);                   # rates of a, s, r
  sd = -(n' * a) * (n' * ad) / s;
  rd = -sd / s * r + joint.radius / s * ((n' * ad) * a + (n' * a) * ad);
  wrench = [eye(3); 0, -r(3), r(2); r(3), 0, -r(1); -r(2), r(1), 0];
  rows = wrench' * six;
  gamma = wrench' * turning (k, joint, rate) - ne_cross (w, rd);
  gap = n ...
      * (n' * P' * (at (k, joint.child, joint.point_b) - at (k, joint.parent, joint.point_a)) ...
           - joint.radius * s);
end

## laws of motion and constraints that the user writes: each one a function that gives [gap, row,
## rate, gamma]
function k = on_speeds (k, m, q, u, t)
  k.U = zeros (0, columns (k.E));
  k.gap_user = k.rate_user = k.gamma_user = zeros (0, 1);
  if (! isfield (m, "user"))
    return;
  end
  for c = m.user
    [gap, row, rate, gamma] = c{1} (t, q, u);
    k.U = [k.U; row];
    k.gap_user = [k.gap_user; gap];
    k.rate_user = [k.rate_user; rate];
    k.gamma_user = [k.gamma_user; gamma];
  end
end

function k = forces (k, m)
  n = numel (m.body);
  k.mass = zeros (6 * n);
  k.force = zeros (6 * n, 1);
  for b = 1:n
    six = 6 * b - (5:-1:0);
    inertia = k.R(:, :, b) * m.body(b).inertia * k.R(:, :, b)';
    k.mass(six, six) = [m.body(b).mass * eye(3), zeros(3); zeros(3), inertia];
    k.force(six) = [m.body(b).mass * m.gravity; -ne_cross(k.w(:, b), inertia * k.w(:, b))];
  end
  if (isfield (m, "given"))
    for f = m.given
      R = eye (3);
      if (strcmp (f.frame, "link"))
        R = turned (k, f.body);
      end
      k.force += point_rows (k, n, f.body, at (k, f.body, f.point))' * [R * f.force; R * f.torque];
    end
  end
  if (isfield (m, "spring"))
    for s = m.spring
      xA = at (k, s.a, s.point_a);
      xB = at (k, s.b, s.point_b);
      d = norm (xB - xA);
      e = (xB - xA) / d;
      rows = point_rows (k, n, s.b, xB)(1:3, :) - point_rows (k, n, s.a, xA)(1:3, :);
      k.force -= rows' * e ...
          * (s.stiffness * (d - s.rest) + s.damping * (e' * (rows * [k.v; k.w](:))));
    end
  end
end

function A = twice (P)
  A = [P, zeros(3); zeros(3), P];
end

## parent's joint axes in the world
function P = frame_a (k, joint)
  P = turned (k, joint.parent) * joint.frame_a;
end

function R = turned (k, b)
  R = eye (3);
  if (b)
    R = k.R(:, :, b);
  end
end

## positions: x(X) = origin + R X for the point that was at X in the reference configuration; joint
## b leads to body b, drawn to it or from it
function k = place (m, q, first_q)
  n = numel (m.body);
  k.R = zeros (3, 3, n);
  k.origin = k.com = zeros (3, n);
  for b = 1:n
    joint = m.joint(b);
    [~, nu] = ne_sizes (joint);
    [s, R] = ne_freedom (joint, q(first_q(b)+1:first_q(b+1)), zeros (nu, 1));
    if (joint.child == b)
      P = turned (k, joint.parent) * joint.frame_a;
      k.R(:, :, b) = P * R * joint.frame_b';
      k.origin(:, b) = at (k, joint.parent, joint.point_a) + P * s - k.R(:, :, b) * joint.point_b;
    else
      P = turned (k, joint.child) * joint.frame_b * R';
      k.R(:, :, b) = P * joint.frame_a';
      k.origin(:, b) = at (k, joint.child, joint.point_b) - P * s - k.R(:, :, b) * joint.point_a;
    end
    k.com(:, b) = k.origin(:, b) + k.R(:, :, b) * m.body(b).com;
  end
end

function x = at (k, b, X)
  x = X;
  if (b)
    x = k.origin(:, b) + k.R(:, :, b) * X;
  end
end

function rows = point_rows (k, n, b, x)
  rows = both (zeros (6, 6 * n), k, b, x, eye (3));
end

function [w, centripetal] = spin (k, b, x)
  w = centripetal = zeros (3, 1);
  if (b)
    w = k.w(:, b);
    centripetal = ne_cross (w, ne_cross (w, x - k.com(:, b)));
  end
end
