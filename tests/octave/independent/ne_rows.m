## k = ne_rows (M, Q, U): maximal coordinates at the joint state Q, U: six velocities [v of the mass centre; w] a body, in world axes.
##
## k.com 3xn, k.R 3x3xn positions and orientations (by recursion from the ground), k.w 3xn, k.v 3xn velocities.
## A tree joint writes six rows, its own motion among them:   k.J a = k.gamma + k.E ud      (row k.free(j) is the joint's motion),
## a loop joint its rows:                                      k.L a = k.gamma_loop          (k.gap is the distance still open).
## The transposed rows carry the forces: free row = joint effort, loop row = force on body B by body A.
## k.mass (6n x 6n, about the mass centres) and k.force (gravity and gyroscopic moments) close Newton and Euler: mass a = force + rows' * efforts.

function k = ne_rows (m, q, u)
  n = numel (m.body);
  k = place (m, q);
  k.J = zeros (6 * n);
  k.E = zeros (6 * n, n);
  for j = 1:n
    joint = m.joint(j);
    k.free(j) = 6 * j - 5 + 3 * ! strcmp (joint.type, "prismatic");
    k.E(k.free(j), j) = 1;
    k.J(6 * j - (5:-1:0), :) = hinge_rows (k, n, joint.parent, joint.child, k.hinge(:, j), k.frame(:, :, j));
  end
  velocity = reshape (k.J \ (k.E * u(:)), 6, n);
  k.v = velocity(1:3, :);
  k.w = velocity(4:6, :);
  k.gamma = zeros (6 * n, 1);
  for j = 1:n
    joint = m.joint(j);
    slides = strcmp (joint.type, "prismatic");
    k.gamma(6 * j - (5:-1:0)) = hinge_gamma (k, joint.parent, joint.child, k.hinge(:, j), k.frame(:, :, j), u(j) * [slides; ! slides]);
  end
  k.L = zeros (0, 6 * n);
  k.gamma_loop = k.gap = zeros (0, 1);
  for loop = m.loop
    [rows, gamma, gap] = loop_rows (k, n, loop, velocity(:));
    k.L = [k.L; rows];
    k.gamma_loop = [k.gamma_loop; gamma];
    k.gap = [k.gap; gap];
  end
  k.mass = zeros (6 * n);
  k.force = zeros (6 * n, 1);
  for b = 1:n
    inertia = k.R(:, :, b) * m.body(b).inertia * k.R(:, :, b)';
    k.mass(6 * b - (5:-1:0), 6 * b - (5:-1:0)) = blkdiag (m.body(b).mass * eye (3), inertia);
    k.force(6 * b - (5:-1:0)) = [m.body(b).mass * m.gravity; -cross(k.w(:, b), inertia * k.w(:, b))];
  end
end

## motion of body B against body A at the point x, in the axes of `frame` (columns, fixed to A): three rows of translation, three of rotation
function rows = hinge_rows (k, n, A, B, x, frame)
  rows = kron (eye (2), frame') * (point_rows (k, n, B, x) - point_rows (k, n, A, x));
end

## what these rows give of the accelerations: rows a = gamma + second rates; rate = speed along and about the first axis of the frame
function gamma = hinge_gamma (k, A, B, x, frame, rate)
  [wA, centripetal_A] = spin (k, A, x);
  [~, centripetal_B] = spin (k, B, x);
  gamma = [frame' * (centripetal_A - centripetal_B + 2 * cross(wA, frame(:, 1) * rate(1)));
           frame' * cross(wA, frame(:, 1) * rate(2))];
end

## rows, right-hand side and gap of a loop joint: by its `directions` (points coincide along them), or whole by its `type` and `axis`
function [rows, gamma, gap] = loop_rows (k, n, loop, velocity)
  xA = at (k, loop.bodyA, loop.pointA);
  xB = at (k, loop.bodyB, loop.pointB);
  if (isempty (loop.type))
    [~, centripetal_A] = spin (k, loop.bodyA, xA);
    [~, centripetal_B] = spin (k, loop.bodyB, xB);
    rows = loop.directions' * (point_rows (k, n, loop.bodyB, xB) - point_rows (k, n, loop.bodyA, xA))(1:3, :);
    gamma = loop.directions' * (centripetal_A - centripetal_B);
    gap = loop.directions' * (xB - xA);
    return;
  end
  R = turned (k, loop.bodyA);
  frame = R * [loop.axis, null(loop.axis')];
  frame(:, 3) *= det (frame);
  six = hinge_rows (k, n, loop.bodyA, loop.bodyB, xB, frame);
  rate = six * velocity;
  relative = R' * turned (k, loop.bodyB);
  tilt = R * [relative(3, 2) - relative(2, 3); relative(1, 3) - relative(3, 1); relative(2, 1) - relative(1, 2)] / 2;
  six_gap = frame' * [xB - xA, tilt];
  if (strcmp (loop.type, "prismatic"))
    held = [2, 3, 4, 5, 6];
    gamma = hinge_gamma (k, loop.bodyA, loop.bodyB, xB, frame, [rate(1); 0]);
  else
    held = [1, 2, 3, 5, 6];
    gamma = hinge_gamma (k, loop.bodyA, loop.bodyB, xB, frame, [0; rate(4)]);
    about = frame' * turned (k, loop.bodyB) * loop.axis;
    six_gap([5, 6]) = [-about(3), about(2)];
  end
  rows = six(held, :);
  gamma = gamma(held);
  gap = six_gap(held)(:);
end

function R = turned (k, b)
  R = eye (3);
  if (b)
    R = k.R(:, :, b);
  end
end

## positions: x(X) = origin + R X for the point that was at X when q = 0
function k = place (m, q)
  n = numel (m.body);
  k.R = zeros (3, 3, n);
  k.origin = k.com = k.hinge = zeros (3, n);
  k.frame = zeros (3, 3, n);
  for j = 1:n
    joint = m.joint(j);
    Rp = turned (k, joint.parent);
    b = joint.child;
    if (strcmp (joint.type, "prismatic"))
      Rb = Rp;
      hinge = at (k, joint.parent, joint.point + joint.axis * q(j));
    else
      Rb = Rp * turn (joint.axis, q(j));
      hinge = at (k, joint.parent, joint.point);
    end
    k.R(:, :, b) = Rb;
    k.origin(:, b) = hinge - Rb * joint.point;
    k.com(:, b) = k.origin(:, b) + Rb * m.body(b).com;
    k.hinge(:, j) = hinge;
    k.frame(:, :, j) = Rp * [joint.axis, null(joint.axis')];
  end
end

function x = at (k, b, X)
  x = X;
  if (b)
    x = k.origin(:, b) + k.R(:, :, b) * X;
  end
end

## velocity of the point x of body b, and its angular velocity, as rows on all velocities
function rows = point_rows (k, n, b, x)
  rows = zeros (6, 6 * n);
  if (b)
    d = x - k.com(:, b);
    rows(:, 6 * b - (5:-1:0)) = [eye(3), -[0, -d(3), d(2); d(3), 0, -d(1); -d(2), d(1), 0]; zeros(3), eye(3)];
  end
end

function [w, centripetal] = spin (k, b, x)
  w = centripetal = zeros (3, 1);
  if (b)
    w = k.w(:, b);
    centripetal = cross (w, cross (w, x - k.com(:, b)));
  end
end

function R = turn (axis, angle)
  R = expm (angle * [0, -axis(3), axis(2); axis(3), 0, -axis(1); -axis(2), axis(1), 0]);
end
