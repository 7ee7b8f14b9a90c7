## Every joint as the cut joint of a loop, against closed forms: positions, speeds, accelerations of
## the loop along its motion, the motion itself under its forces, assembly from a rough guess.
## Nothing here is computed by GSMBP but what is judged.
##
## A loop of one freedom is a set of poses over one coordinate th: with I(th) = sum m |c'|^2 + w J w
## (c', w by th) and the potential V(th)
##   I th'' = Q - V' - I' th'^2 / 2          (poses/pose_*.m).

function test_closures ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  bennett ();
  inverted_crank ();
  four_cylinders ();
  bent_shaft ();
  crank_rod_rocker ();
  lead_screw ();
  jack ();
  swash_plate ();
  weld ();
  free_bodies ();
end

## ------------------------------------------------------------------------------------ closed loops

## Bennett: tan(q1/2) tan(q2/2) = sin((be+al)/2) / sin((be-al)/2), opposite angles opposite
function bennett ()
  m = gsmbp_fixture ("close_revolute");
  [a, b, al, be] = deal (0.2, 0.4, pi/6, pi/2);
  q2 = @(th) 2 * atan (sin ((be + al) / 2) / sin ((be - al) / 2) / tan (th / 2));
  closed = @(th) [th; q2(th); -q2(th)];
  place = @(th) cat (3, along (th, 0), along (th, 0) * tilt (al, a) * along (q2(th), 0), ...
                     inv (tilt (al, a) * along (-q2(th), 0) * tilt (be, b)));
  body = pose_bodies ([1, 1.5, 1.2], [0.1, 0.2, 0.1; 0, 0.02, 0; 0.01, 0, 0], ...
                      {diag([0.001, 0.004, 0.004]), diag([0.002, 0.03, 0.03]), ...
                       diag([0.001, 0.004, 0.004])});
  along_motion ("hinge (Bennett)", m, closed, [0.5, 1, 2, 3, 4.5, 5.5], 1);
  under_forces ("hinge (Bennett)", m, closed, place, body, [0; -9.81; 0], @(th, w) 0.5, ...
                [0.5, 1, 2, 3, 4.5, 5.5], 1);
  in_time ("hinge (Bennett)", m, closed, 1, 3, [0, 2], 0.5);
  assembled ("hinge (Bennett)", m, closed, "q1", 1, [0; 0.2; -0.2]);
  balance (m, closed, place, body, 1, 1);
end

## bar 2 of Bennett's linkage under the forces of its two hinges, which are not unique: Newton and
## Euler hold whatever they are
function balance (m, closed, place, body, th, w)
  x = [closed(th); pose_slope(closed, th) * w];
  [xd, ~] = m.rhs (0, x);
  [y, ~] = m.out (0, x);
  [F2, M2] = pose_reaction (m, y, "second");
  [F3, M3] = pose_reaction (m, y, "third");
  T = place (th);
  [p2, p3] = deal (T(1:3, 4, 2), T(1:3, 4, 3));
  second = @(list) list(:, 2);
  c = @(th) second (pose_centres (place (th), body));
  L = @(th) second (pose_momentum (place, body, th));
  acceleration = pose_bend (c, th) * w ^ 2 + pose_slope (c, th) * xd(4);
  turning = pose_slope (L, th) * w ^ 2 + L(th) * xd(4);
  gsmbp_check ("hinge (Bennett): Newton's law for bar 2, N", ...
               F2 - F3 + 1.5 * [0; -9.81; 0] - 1.5 * acceleration, 1e-10);
  gsmbp_check ("hinge (Bennett): Euler's law for bar 2, N m", ...
               M2 - M3 + cross (p2 - c(th), F2) - cross (p3 - c(th), F3) - turning, 1e-10);
end

## crank a about the origin, guide about (-d, 0): the guide points from there to the tip
function inverted_crank ()
  m = gsmbp_fixture ("close_prismatic");
  [a, d] = deal (0.2, 0.5);
  psi = @(th) atan2 (a * sin (th), a * cos (th) + d);
  closed = @(th) [th; psi(th) - th; psi(th)];
  tip = @(th) [a * cos(th); a * sin(th); 0];
  place = @(th) cat (3, pose_turn (3, th), pose_go (tip (th)) * pose_turn (3, psi(th)), ...
                     pose_go ([-d; 0; 0]) * pose_turn (3, psi(th)));
  body = pose_bodies ([0.9, 0.4, 1.4], [0.1, 0.01, 0.3; 0, 0.02, 0; 0, 0, 0], ...
                      {diag([0.0002, 0.006, 0.006]), 0.0003 * eye(3), ...
                       diag([0.0004, 0.04, 0.04])});
  th = [-3, -1, 0, 0.5, 1, 2.5];
  gsmbp_check ("prismatic: two rows are left in the plane", m.sizes.nlam == 2);
  along_motion ("prismatic (inverted crank)", m, closed, th, 1);
  under_forces ("prismatic (inverted crank)", m, closed, place, body, [0; -9.81; 0], @(th, w) 2, ...
                th, 1);
  in_time ("prismatic (inverted crank)", m, closed, 1, 10, [0, 1], 2);
  assembled ("prismatic (inverted crank)", m, closed, "theta", 1, [0; 0.3; -0.2]);
end

## RCCC. Principle of transference: what holds for the angles of the spherical four-bar holds for
## dual numbers angle + eps*displacement; eps is an imaginary step here.
function four_cylinders ()
  m = gsmbp_fixture ("close_cylindrical");
  [al, a, s1] = deal ([0.5, 1.2, 1.1, 1.4], [0.1, 0.3, 0.25, 0.35], 0.05);
  step = 1e-30;
  angles = @(th) spherical_four_bar (th, al);
  shifts = @(th) imag (spherical_four_bar (th + 1i * step * s1, al + 1i * step * a)) / step;
  closed = @(th) [th; shifts(th)(2); angles(th)(2); shifts(th)(4); angles(th)(4)];
  last = @(th) inv (tilt (al(3), a(3)) * along (angles (th)(4), shifts (th)(4)) ...
                      * tilt (al(4), a(4)));
  place = @(th) cat (3, along (th, s1), ...
                     along (th, s1) * tilt (al(1), a(1)) ...
                       * along (angles (th)(2), shifts (th)(2)), last (th));
  body = pose_bodies ([1, 1.5, 1.2], [0.05, 0.15, 0.1; 0.01, 0, -0.02; 0.02, 0.05, 0], ...
                      {diag([0.001, 0.004, 0.004]), diag([0.002, 0.03, 0.03]), ...
                       diag([0.001, 0.004, 0.004])});
  th = [-3, -1, 0.3, 1.9, 4];
  gsmbp_check ("cylindrical: four rows", m.sizes.nlam == 4);
  along_motion ("cylindrical (RCCC)", m, closed, th, 1);
  under_forces ("cylindrical (RCCC)", m, closed, place, body, [0; 0; -9.81], @(th, w) 1, th, 1);
  in_time ("cylindrical (RCCC)", m, closed, 1.9, 6, [0, 0.3], 1);
  assembled ("cylindrical (RCCC)", m, closed, "q1", 1.9, [0; 0.02; -0.15; 0.05; 0.2]);
end

## angles t of Z(t1) X(al1) Z(t2) X(al2) Z(t3) X(al3) Z(t4) X(al4) = 1, one branch; analytic in all
## its arguments
function t = spherical_four_bar (t1, al)
  k = [0; 0; 1];
  second = turn_z (t1) * turn_x (al(1)) * k;
  third = @(t4) turn_x (al(4)).' * turn_z (t4).' * turn_x (al(3)).' * k;
  level = second.' * (third (0) + third (pi)) / 2;
  A = second.' * third (0) - level;
  B = second.' * third (pi / 2) - level;
  C = cos (al(2)) - level;
  t4 = 2 * atan ((B + sqrt (A ^ 2 + B ^ 2 - C ^ 2)) / (A + C));
  Q = turn_x (al(1)).' * turn_z (t1).' * turn_x (al(4)).' * turn_z (t4).' * turn_x (al(3)).';
  t = [t1, angle_of(Q(1, 3), -Q(2, 3)), angle_of(Q(3, 1), Q(3, 2)), t4];
end

function t = angle_of (s, c)
  t = 2 * atan (s / (c + sqrt (c ^ 2 + s ^ 2)));
end

## two universal joints: tan(phi) = cos(b1) tan(theta), tan(psi) = tan(phi) / cos(b2)
function bent_shaft ()
  m = gsmbp_fixture ("close_universal");
  for bends = [pi/6, pi/6; pi/4, pi/6]
    [b1, b2] = deal (bends(1), bends(2));
    name = sprintf ("universal (bends of %.0f and %.0f degrees)", 180 / pi * bends);
    shaft = gsmbp_set (m, "b1", b1, "b2", b2);
    phi = @(th) atan2 (cos (b1) * sin (th), cos (th));
    psi = @(th) atan2 (sin (phi (th)), cos (phi (th)) * cos (b2));
    closed = @(th) [th; cross_angles(th, phi (th), b1); psi(th)];
    n = [cos(b1); sin(b1); 0];
    out = [cos(b1 + b2); sin(b1 + b2); 0];
    place = @(th) cat (3, pose_turn (1, th), pose_turn (n, phi (th)), ...
                       pose_go (0.4 * n) * pose_turn (out, psi (th)));
    middle = 0.003 * n * n' + 0.02 * (eye (3) - n * n');
    body = pose_bodies ([2, 1, 3], [[-0.2; 0; 0], 0.2 * n, zeros(3, 1)], ...
                        {diag([0.02, 0.05, 0.05]), middle, 0.05 * eye(3)});
    th = [-2.5, -1, 0, 0.7, 1.4, 3];
    along_motion (name, shaft, closed, th, 1);
    under_forces (name, shaft, closed, place, body, zeros (3, 1), @(th, w) 0.8, th, 1);
    in_time (name, shaft, closed, 0.7, 8, [0, 2], 0.8);
    if (b1 == b2)
      x = gsmbp_run (shaft, linspace (0, 2, 21), [closed(0.7); pose_slope(closed, 0.7) * 8], []);
      gsmbp_check ([name ": equal bends transmit evenly"], x(:, 4) - x(:, 1), 1e-10);
    end
  end
  assembled (name, shaft, closed, "theta", 0.7, [0; 0.1; -0.1; 0.1]);
end

## the two angles of the first cross: Rx(th) Rot(z, c1) Rot(u, c2) = Rot(n, phi), u across z and n
function c = cross_angles (th, phi, b1)
  n = [cos(b1); sin(b1); 0];
  u = [-sin(b1); cos(b1); 0];
  W = pose_turn (1, -th)(1:3, 1:3) * pose_turn (n, phi)(1:3, 1:3);
  Wu = W * u;
  c1 = atan2 (-Wu' * n, Wu' * u);
  back = pose_turn (3, -c1)(1:3, 1:3) * W;
  c = [c1; atan2(-(back * n)(3), (back * n)' * n)];
end

## RUSR: the ball is at the distance l of the crank's tip
function crank_rod_rocker ()
  m = gsmbp_fixture ("close_spherical");
  [a, l, c, D] = deal (0.15, 0.5, 0.3, [0.35; 0.15; 0.15]);
  tip = @(th) a * [cos(th); sin(th); 0];
  for branch = [1, -1]
    psi = @(th) rocker_angle (D - tip (th), l, c, branch);
    ball = @(th) D + c * [sin(psi (th)); 0; cos(psi (th))];
    rod = @(th) (ball (th) - tip (th)) / l;
    closed = @(th) [th; rod_angles(pose_turn(3, -th)(1:3, 1:3) * rod(th)); psi(th)];
    place = @(th) cat (3, pose_turn (3, th), rod_frame (closed (th), tip (th)), ...
                       pose_go (D) * pose_turn (2, psi (th)));
    J = 1.1 * l ^ 2 / 12;
    body = pose_bodies ([0.8, 1.1, 1.3], [a/2, l/2, 0; 0, 0, 0; 0, 0, c/2], ...
                        {diag([0, 0.002, 0.002]), diag([0, J, J]), diag([0.01, 0.01, 0])});
    name = sprintf ("spherical (RUSR, branch %+d)", branch);
    th = [-3, -1.5, 0, 0.4, 1, 2.5];
    along_motion (name, m, closed, th, 1);
    under_forces (name, m, closed, place, body, [0; 0; -9.81], @(th, w) 0.6, th, 1);
    in_time (name, m, closed, 0.4, 8, [0, 1], 0.6);
    assembled (name, m, closed, "theta", 0.4, [0; 0.1; -0.1; 0.1]);
  end
end

function psi = rocker_angle (e, l, c, branch)
  psi = atan2 (e(1), e(3)) + branch ...
      * acos ((l ^ 2 - c ^ 2 - e' * e) / (2 * c * hypot (e(1), e(3))));
end

function u = rod_angles (d)
  u = [atan2(d(2), d(1)); -asin(d(3))];
end

function T = rod_frame (q, tip)
  T = pose_go (tip) * pose_turn (3, q(1) + q(2)) * pose_turn (2, q(3));
end

## lead screw: displacement -h*theta (the nut turns back against the screw), (J + m h^2) theta'' =
## tau - c theta' + m g h
function lead_screw ()
  m = gsmbp_fixture ("close_helical");
  h = 0.005 / (2 * pi);
  gsmbp_check ("helical (lead screw): one row is left", m.sizes.nlam == 1);
  gap = [];
  for turns = [0, 0.3, 7, -1000]
    th = 2 * pi * turns + 0.4;
    gap(end+1) = m.con (0, [th; -h * th], [0; 0]);
  end
  gsmbp_check ("helical (lead screw): closed after 0, 0.3, 7 and -1000 turns, m", gap, 1e-15);
  [J, c, Q] = deal (0.0002 + 4 * h ^ 2, 0.0001, 0.1 + 4 * 9.81 * h);
  t = linspace (0, 6, 61)';
  x = gsmbp_run (m, t, zeros (4, 1), []);
  speed = Q / c * (1 - exp (-c / J * t));
  angle = Q / c * (t - J / c * (1 - exp (-c / J * t)));
  printf ("   (%.0f turns)\n", angle(end) / (2 * pi));
  gsmbp_check ("helical (lead screw): angle in closed form, of the last", ...
               (x(:, 1) - angle) / angle(end), 1e-11);
  gsmbp_check ("helical (lead screw): speed in closed form, of the last", ...
               (x(:, 3) - speed) / speed(end), 1e-11);
  gsmbp_check ("helical (lead screw): the nut keeps step, m", x(:, 2) + h * x(:, 1), 1e-13);
end

## arm, screw and ground are a triangle whose third side is l0 - h*turn; the thread's own
## coordinate, which counts the turns, is -turn
function jack ()
  m = gsmbp_fixture ("close_jack");
  [a, D, l0, h] = deal (0.5, [0.4; 0; 0], 0.45, 0.001);
  tip = @(th) a * [cos(th); sin(th); 0];
  side = @(th) D - tip (th);
  direction = @(th) atan2 (side (th)(2), side (th)(1));
  turn = @(th) (l0 - norm (side (th))) / h;
  closed = @(th) [th; direction(th) - th; turn(th); direction(th); -turn(th)];
  ## the screw spins too fast for differences of its pose: its inertia 0.0005 about its axis is a
  ## mass that goes `turn` metres sideways
  place = @(th) cat (3, pose_turn (3, th), pose_go (tip (th)) ...
      * pose_turn (3, direction (th)), pose_go (tip (th)) * pose_turn (3, direction (th)), ...
                     pose_go (D) * pose_turn (3, direction (th)), pose_go ([turn(th); 0; 0]));
  body = pose_bodies ([6, 0.5, 1, 0.7, 0.0005], [0.3, 0, 0.2, 0, 0; 0.05, 0, 0, 0, 0; 0, 0, 0, ...
      0, 0], ...
                      {diag([0.01, 0.3, 0.3]), 0.001 * eye(3), diag([0, 0.02, 0.02]), ...
                       0.001 * eye(3), zeros(3)});
  friction = @(th, w) -0.02 * pose_slope (turn, th) ^ 2 * w;
  th = [0.7, 1, 1.3, 1.6];
  printf ("   (%.0f turns from %.1f to %.1f rad)\n", (turn (th(1)) - turn (th(end))) / (2 * pi), ...
          th(1), th(end));
  along_motion ("helical (jack)", m, closed, th, 1);
  ## turn = side/h: the differences of 500 rad are good to 1e-12 of them
  under_forces ("helical (jack)", m, closed, place, body, [0; -9.81; 0], friction, th, 10);
  in_time ("helical (jack)", m, closed, 1.6, -0.1, [0, 5], []);
end

## swash plate: the piston stands at s = -r tan(b) cos(theta), the slipper's axis is the plate's;
## its spin about that axis stays
function swash_plate ()
  m = gsmbp_fixture ("close_planar");
  gsmbp_check ("planar: three rows", m.sizes.nlam == 3);
  [b, r, js, mass, jk, spin] = deal (0.3, 0.06, 0.004, 0.8, 0.0001, 7);
  I = @(th) js + mass * (r * tan (b) * sin (th)) ^ 2 + jk * sin (b) ^ 2;
  dI = @(th) mass * (r * tan (b)) ^ 2 * sin (2 * th);
  [gap, rate, acceleration] = deal ([]);
  for th = [-3, -1, 0, 0.7, 2]
    [x, w] = deal (swash_state (th, 5, 0.3 * th, spin, b, r), 5);
    [phi, phit, H] = m.con (0, x(1:6), x(7:11));
    gap(:, end+1) = phi;
    rate(:, end+1) = H * x(7:11) + phit;
    xd = m.rhs (0, x);
    acceleration(end+1) = xd(7) ...
        - (0.3 - mass * 9.81 * r * tan (b) * sin (th) - dI (th) * w ^ 2 / 2) / I (th);
  end
  gsmbp_check ("planar (swash plate): closed, m", gap, 1e-14);
  gsmbp_check ("planar (swash plate): closed speeds, m/s", rate, 1e-14);
  gsmbp_check ("planar (swash plate): acceleration, rad/s^2", acceleration, 1e-11);
  t = linspace (0, 1, 21);
  x = gsmbp_run (m, t, swash_state (0.7, 5, 0, spin, b, r), []);
  energy = @(x) (I (x(1)) * x(7) ^ 2 + jk * spin ^ 2) / 2 + mass * 9.81 ...
      * (-r * tan (b) * cos (x(1))) - 0.3 * x(1);
  for i = 1:numel (t)
    n = pose_turn (3, x(i, 1))(1:3, 1:3) * [sin(b); 0; cos(b)];
    R = pose_rotation (x(i, 3:6));
    kept(i, :) = [energy(x(i, :)) - energy(x(1, :)), n' * R * x(i, 9:11)' - spin, ...
                  norm(R(:, 3) - n)];
  end
  printf ("   (%.1f turns)\n", (x(end, 1) - x(1, 1)) / (2 * pi));
  gsmbp_check ("planar (swash plate): piston, m", x(:, 2) + r * tan (b) * cos (x(:, 1)), 1e-12);
  gsmbp_check ("planar (swash plate): energy integral, J", kept(:, 1), 1e-11);
  gsmbp_check ("planar (swash plate): spin of the slipper, rad/s", kept(:, 2), 1e-10);
  gsmbp_check ("planar (swash plate): the slipper stands square on the plate", kept(:, 3), 1e-11);
end

function x = swash_state (th, w, sigma, spin, b, r)
  R = (pose_turn (3, th) * pose_turn (2, b) * pose_turn (3, sigma))(1:3, 1:3);
  n = R(:, 3);
  omega = cross (n, cross ([0; 0; w], n)) + spin * n;
  x = [th; -r * tan(b) * cos(th); pose_quaternion(R); w; r * tan(b) * sin(th) * w; R' * omega];
end

## welded halves: one pendulum; the weld's moment about the common line is what keeps the halves
## together
function weld ()
  m = gsmbp_fixture ("close_fixed");
  closed = @(th) [th; th];
  place = @(th) cat (3, pose_go ([0; -0.2; 0]) * pose_turn (2, th), ...
                     pose_go ([0; 0.3; 0]) * pose_turn (2, th));
  J1 = [0.025, 0.001, 0.002; 0.001, 0.03, 0; 0.002, 0, 0.015];
  J2 = [0.04, 0, 0; 0, 0.05, -0.002; 0, -0.002, 0.03];
  body = pose_bodies ([2, 3], [0.1, -0.05; -0.1, 0.2; -0.3, -0.2], {J1, J2});
  th = [-2, 0, 0.5, 1.7];
  along_motion ("fixed (weld)", m, closed, th, 1);
  under_forces ("fixed (weld)", m, closed, place, body, [0; 0; -9.81], @(th, w) 0, th, 1);
  in_time ("fixed (weld)", m, closed, 0.5, 3, [0, 2], 0);
  x = [0.5; 0.5; 3; 3];
  [xd, ~] = m.rhs (0, x);
  [y, ~] = m.out (0, x);
  [F, M] = pose_reaction (m, y, "w");
  R = pose_turn (2, 0.5)(1:3, 1:3);
  own = 0.05 + 3 * (0.05 ^ 2 + 0.2 ^ 2);
  weight = cross (R * [-0.05; 0.2; -0.2], 3 * [0; 0; -9.81]);
  arm = cross (R * [0.1; -0.3; -0.3], F);
  gsmbp_check ("fixed (weld): its moment about the line of the hinges, N m", ...
               own * xd(4) - weight(2) - M(2) - arm(2), 1e-12);
end

## ---------------------------------------------------------------------- bodies bound to the ground

## A body free in space and bound by a cut joint. Its possible motions: the joint's point moves by V
## du, the body turns by W du; what must happen is M a = F + forces that do no work on these
## (principle of virtual power).
function free_bodies ()
  m = gsmbp_fixture ("close_free");
  types = {"revolute", "prismatic", "cylindrical", "universal", "spherical", "planar", "helical"};
  gsmbp_check (["free bodies: 50 coordinates (one counts the screw's turns), 43 speeds, 30 " ...
                "rows"], m.sizes.nq == 50 && m.sizes.nu == 43 && m.sizes.nlam == 30);
  ## ten whole turns of the screw among the displacements
  freedoms = {0.8, 0.35, [0.2; -0.6], [0.5; -0.4], [0.3; 0.8; -0.2], [0.1; -0.2; 0.7], ...
              20 * pi + 0.6};
  rates = {1.5, -0.7, [0.9; 2], [1.2; -0.8], [2; -1; 0.5], [0.6; 0.4; -1.3], 25};
  x = zeros (m.sizes.nx, 1);
  for k = 1:7
    b(k) = bound_body (types{k}, freedoms{k}, rates{k});
    [iq, iu] = places (m, types{k});
    x([iq, iu]) = [b(k).p; pose_quaternion(b(k).R); b(k).v; b(k).R' * b(k).w];
  end
  x(strncmp (m.states, "q_j_helical", 11)) = [freedoms{7}; rates{7}];
  [phi, phit, H] = m.con (0, x(1:50), x(51:end));
  gsmbp_check ("free bodies: closed", phi, 1e-14);
  gsmbp_check ("free bodies: closed speeds", H * x(51:end) + phit, 1e-13);
  gsmbp_check ("free bodies: rank", rank (H) == 30);
  xd = m.rhs (0, x);
  for k = 1:7
    [~, iu] = places (m, types{k});
    found = [eye(3), zeros(3); zeros(3), b(k).R] * xd(iu);
    gsmbp_check (sprintf ("free body bound by a %s joint: accelerations", types{k}), ...
                 found - b(k).a, 1e-11);
  end
  t = linspace (0, 2, 41);
  r = gsmbp_simulate (m, x, t, "rtol", 1e-12, "atol", 1e-12, "maxsteps", 100000);
  E = arrayfun (@(i) [1, 1, 0, 0, 0] * m.ene (0, r.x(i, :)')(:), 1:numel (t));
  gsmbp_check ("free bodies: energy over 2 s, J", E - E(1), 1e-9);
  gsmbp_check ("free bodies: norm of the Euler parameters", norms (m, r.x) - 1, 1e-13);
  screw (r.x(:, places (m, "helical")));
  [slide, wanted] = slid (r.x(:, places (m, "prismatic")), t);
  gsmbp_check ("free body on a prismatic joint: uniform acceleration, m", slide - wanted, 1e-10);
end

## where the seven coordinates and six speeds of a body stand in the state
function [iq, iu] = places (m, type)
  iq = find (strcmp (m.states, ["q_f_" type "1"])) + (0:6);
  iu = find (strcmp (m.states, ["q_f_" type "1_d"])) + (0:5);
end

function n = norms (m, x)
  sets = m.json.orientation;
  for k = 1:rows (sets)
    n(:, k) = sqrt (sumsq (x(:, sets(k, :)), 2));
  end
end

## the screw: displacement over angle, turns counted
function screw (x)
  [P, C, p, c] = placement ();
  for i = 1:rows (x)
    R = pose_rotation (x(i, 4:7));
    rel = P' * R * C;
    angle(i, 1) = atan2 (rel(1, 3), rel(1, 1));
    d(i, 1) = (P' * (x(i, 1:3)' + R * c - p))(2);
  end
  angle = unwrap (angle);
  printf ("   (%.1f turns)\n", (angle(end) - angle(1)) / (2 * pi));
  gsmbp_check ("free body on a screw: displacement = pitch*angle, m", ...
               d - d(1) - 0.02 * (angle - angle(1)), 1e-11);
end

function [found, wanted] = slid (x, t)
  [P, C, p, c] = placement ();
  e = P * [1; 2; 2] / 3;
  for i = 1:rows (x)
    found(i) = e' * (x(i, 1:3)' + pose_rotation (x(i, 4:7)) * c - p);
  end
  wanted = 0.35 - 0.7 * t + e' * [0; -3; -9] * t .^ 2 / 2;
end

function [P, C, p, c] = placement ()
  P = (pose_turn (3, 0.4) * pose_turn (1, 0.7))(1:3, 1:3);
  C = (pose_turn (2, -0.5) * pose_turn (3, 1.1))(1:3, 1:3);
  p = [0.2; -0.1; 0.3];
  c = [-0.1; 0.05; 0.2];
end

## pose (origin p, axes R), speeds (of the origin v, angular w, ground axes) and accelerations a
## (origin, angular) of a body on a joint
function b = bound_body (type, q, u)
  [P, C, p, c] = placement ();
  [J, mass, centre] = deal ([0.05, 0.01, 0.008; 0.01, 0.06, -0.005; 0.008, -0.005, 0.07], 2, ...
                            [0.1; -0.05; 0.08]);
  [turn, d, W, V, bias] = motion_of (type, q, u);
  b.R = P * turn * C';
  [W, V, bias] = deal (P * W, P * V, P * bias);
  b.p = p + P * d - b.R * c;
  b.w = W * u;
  b.v = V * u - cross (b.w, b.R * c);
  [r, inertia] = deal (b.R * (centre - c), b.R * J * b.R');
  B = [V + cross(W, repmat (r, 1, columns (W))); W];
  rest = [cross(bias, r) + cross(b.w, cross (b.w, r)); bias];
  M = blkdiag (mass * eye (3), inertia);
  F = [mass * [0; -3; -9]; -cross(b.w, inertia * b.w)];
  a = B * ((B' * M * B) \ (B' * (F - M * rest))) + rest;
  back = -b.R * centre;
  b.a = [a(1:3) + cross(a(4:6), back) + cross(b.w, cross (b.w, back)); a(4:6)];
end

## in joint axes: turn and displacement d, their rates W u and V u, and what of the angular
## acceleration is not W u'
function [turn, d, W, V, bias] = motion_of (type, q, u)
  [x, y, z] = deal ([1; 0; 0], [0; 1; 0], [0; 0; 1]);
  turn = eye (3);
  d = bias = zeros (3, 1);
  W = V = zeros (3, numel (u));
  switch (type)
    case "revolute"
      turn = pose_turn ([1; 2; 2] / 3, q)(1:3, 1:3);
      W = [1; 2; 2] / 3;
    case "prismatic"
      V = [1; 2; 2] / 3;
      d = V * q;
    case "cylindrical"
      turn = pose_turn (3, q(2))(1:3, 1:3);
      d = z * q(1);
      [V, W] = deal ([z, 0*z], [0*z, z]);
    case "universal"
      turn = (pose_turn (3, q(1)) * pose_turn (1, q(2)))(1:3, 1:3);
      W = [z, pose_turn(3, q(1))(1:3, 1:3) * x];
      bias = cross (W(:, 1), W(:, 2)) * u(1) * u(2);
    case "spherical"
      turn = (pose_turn (1, q(1)) * pose_turn (2, q(2)) * pose_turn (3, q(3)))(1:3, 1:3);
      W = eye (3);
    case "planar"
      turn = pose_turn (1, q(3))(1:3, 1:3);
      d = [0; q(1); q(2)];
      [V, W] = deal ([y, z, 0*x], [0*x, 0*x, x]);
    case "helical"
      turn = pose_turn (2, q)(1:3, 1:3);
      d = 0.02 * q * y;
      [V, W] = deal (0.02 * y, y);
  end
end

## ----------------------------------------------------------------------------------------- judging

## positions, speeds and accelerations of the closed form against the constraints; one freedom.
## Rates come from differences: see pose_slope, pose_bend.
function along_motion (name, m, closed, angles, scale)
  [gap, rate, bent, spare] = deal ([]);
  w = 2;
  for th = angles
    [q, u, ud] = deal (closed (th), pose_slope (closed, th) * w, pose_bend (closed, th) * w ^ 2);
    [phi, phit, H, gam] = m.con (0, q, u);
    gap(:, end+1) = phi;
    rate(:, end+1) = (H * u + phit) / max (1, norm (u));
    bent(:, end+1) = (H * ud - gam) / max (1, norm (ud));
    spare(end+1) = columns (H) - rank (H, 1e-9 * norm (H));
  end
  gsmbp_check ([name ": closed"], gap, 1e-14 * scale);
  gsmbp_check ([name ": closed speeds"], rate, 1e-11 * scale);
  gsmbp_check ([name ": closed accelerations"], bent, 1e-10 * scale);
  gsmbp_check ([name ": one freedom"], spare == 1);
end

## accelerations under the forces
function under_forces (name, m, closed, place, body, gravity, effort, angles, scale)
  away = [];
  w = 2;
  for th = angles
    u = pose_slope (closed, th) * w;
    [xd, ~] = m.rhs (0, [closed(th); u]);   # INFO = 2 where rows are redundant
    n = numel (u);
    rest = pose_effort (place, body, gravity, th, w, 0);
    wanted = (effort (th, w) - rest) / (pose_effort (place, body, gravity, th, w, 1) - rest);
    away(end+1) = (xd(n + 1) - wanted) / max (1, abs (wanted));
  end
  gsmbp_check ([name ": acceleration under its forces"], away, 1e-9 * scale);
end

## the emitted motion stays on the closed form; it is smooth, and its steps show that; the energy
## grows by the work of the TORQUE ([]: there is friction)
function in_time (name, m, closed, th, w, span, torque)
  t = linspace (span(1), span(2), 21);
  [r, info] = gsmbp_simulate (m, [closed(th); pose_slope(closed, th) * w], t, "rtol", 1e-11, ...
                              "atol", 1e-11, "maxsteps", 20000);
  n = m.sizes.nq;
  away = [];
  for i = 1:rows (r.x)
    wanted = closed (r.x(i, 1));
    away(:, end+1) = sin ((r.x(i, 1:n)' - wanted) / 2) * 2 ./ max (1, abs (wanted));
  end
  steps = r.stats.accepted + r.stats.rejected;
  gsmbp_check (sprintf ("%s: %g s of motion in %d steps", name, span(2), steps), ...
               info == 0 && steps < 2000);
  gsmbp_check ([name ": motion on the closed form"], away, 1e-10);
  gsmbp_check ([name ": drift of the loop"], r.stats.drift.phi, 1e-11);
  if (! isempty (torque))
    E = arrayfun (@(i) sum (m.ene (0, r.x(i, :)')(1:2)) - torque * r.x(i, 1), 1:rows (r.x));
    ## some hundred steps at 1e-11 each
    gsmbp_check ([name ": energy less the work of the drive, relative"], ...
                 (E - E(1)) / m.ene (0, r.x(1, :)')(1), 1e-8);
  end
  last = [];
  ways = {"partitioning", "nullspace", "svd", "kane", "baumgarte"};
  ## drift makes redundant rows contradict each other: Baumgarte alone is no way for them
  if (m.json.mobility.rank < m.sizes.nlam)
    ways(end) = [];
  end
  for way = ways
    [o, info] = gsmbp_simulate (m, r.x(1, :)', t, "rtol", 1e-10, "atol", 1e-10, "maxsteps", ...
                                20000, "loops", way{1});
    last(:, end+1) = [(o.x(end, :) - r.x(end, :)) ./ max(1, abs (r.x(end, :))), info]';
  end
  ## integrations at 1e-10 a step, of motions that magnify what is added to them
  gsmbp_check ([name ": the same by the other ways"], last, 1e-6);
end

function assembled (name, m, closed, held, th, off)
  guess = closed (th) + off;
  guess(1) = th;
  x = gsmbp_assemble (m, guess, "hold", {held});
  gsmbp_check ([name ": assembled from a rough guess"], sin (x(1:m.sizes.nq) - closed (th)), 1e-12);
end

## ------------------------------------------------------------ placements of Denavit and Hartenberg

## turn about and go along z; go along and tilt about x
function T = along (angle, d)
  T = eye (4);
  T(1:3, 1:3) = turn_z (angle);
  T(3, 4) = d;
end

function T = tilt (angle, d)
  T = eye (4);
  T(1:3, 1:3) = turn_x (angle);
  T(1, 4) = d;
end

function R = turn_z (t)
  R = [cos(t), -sin(t), 0; sin(t), cos(t), 0; 0, 0, 1];
end

function R = turn_x (t)
  R = [1, 0, 0; 0, cos(t), -sin(t); 0, sin(t), cos(t)];
end
