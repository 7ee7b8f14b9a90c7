## Orientations that are never singular, and those that are: a free asymmetric body in Euler
## parameters against Jacobi's elliptic functions and against two sequences of angles; the norm of
## the parameters; what is said near the singularity of angles.

function test_orientation ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  m = gsmbp_fixture ("orient_free");
  dzhanibekov (m);
  same_motion (m, gsmbp_fixture ("orient_angles"));
  lengths (m);
  through_horizontal (gsmbp_fixture ("case_08a"), gsmbp_fixture ("case_08a_angles"));
end

function [centre, J] = body ()
  centre = [0.1; 0.05; -0.02];
  J = diag ([0.02, 0.05, 0.06]);
end

## started about its middle axis nearly, the body turns over again and again; with L^2 > 2 E I2
##   w1 = a cn, w2 = b sn, w3 = c dn of tau = rate*t, module k
function dzhanibekov (m)
  [centre, J] = body ();
  I = diag (J);
  w0 = [4; 0; 4 * sqrt(I(1) * (I(2) - I(1)) / (I(3) * (I(3) - I(2)))) * 1.0005];
  [E, L] = deal (w0' * J * w0 / 2, norm (J * w0));
  rate = sqrt ((I(3) - I(2)) * (L ^ 2 - 2 * E * I(1)) / prod (I));
  k2 = (I(2) - I(1)) * (2 * E * I(3) - L ^ 2) / ((I(3) - I(2)) * (L ^ 2 - 2 * E * I(1)));
  quarter = ellipke (k2) / rate;
  t = linspace (0, 40 * quarter, 401)';
  [sn, cn, dn] = ellipj (rate * t, k2);
  b = sqrt ((2 * E * I(3) - L ^ 2) / (I(2) * (I(3) - I(2))));
  wanted = [w0(1) * cn, b * sn, w0(3) * dn];
  R0 = (pose_turn (1, 0.3) * pose_turn (2, -0.8))(1:3, 1:3);
  v0 = [0.2; -0.1; 3];
  x0 = [-R0 * centre; pose_quaternion(R0); v0 - R0 * cross(w0, centre); w0];
  x = gsmbp_run (m, t, x0, []);
  printf ("   (turns over ten times in %.2f s, module %.5f)\n", t(end), k2);
  ## next to the separatrix an error grows by exp(2*rate*quarter), some 2e3, at each turning over at
  ## first, then with time only
  gsmbp_check ("orientation: angular velocity over ten turnings, of the largest", ...
               (x(:, 11:13) - wanted) / max (abs (wanted(:))), 1e-7);
  for i = 1:numel (t)
    R = pose_rotation (x(i, 4:7) / norm (x(i, 4:7)));
    momentum(i, :) = R * J * x(i, 11:13)';
    energy(i, 1) = x(i, 11:13) * J * x(i, 11:13)' / 2;
    path(i, :) = x(i, 1:3)' + R * centre;
  end
  gsmbp_check ("orientation: turning energy, relative", energy / E - 1, 1e-11);
  gsmbp_check ("orientation: angular momentum, relative", (momentum - momentum(1, :)) / L, 1e-11);
  gsmbp_check ("orientation: norm of the Euler parameters", sqrt (sumsq (x(:, 4:7), 2)) - 1, 1e-14);
  fall = v0' .* t + [0, 0, -9.81/2] .* t .^ 2;
  gsmbp_check ("orientation: the mass centre falls freely, relative", ...
               (path - fall) / max (abs (fall(:))), 1e-12);
end

## angles about x, y, z and about z, x, z, both away from their singularities for this half second
function same_motion (m, angles)
  [centre, J] = body ();
  R0 = (pose_turn (1, 0.4) * pose_turn (2, 0.5) * pose_turn (3, -0.6))(1:3, 1:3);
  w0 = [2; 1; -3];
  [p, v] = deal ([0.1; 0.2; 0.3], [1; -2; 0.5]);
  t = linspace (0, 0.5, 21);
  x = gsmbp_run (m, t, [p; pose_quaternion(R0); v; w0], []);
  a1 = sequence (R0, [1, 2, 3], [0.4; 0.5; -0.6]);
  a2 = sequence (R0, [3, 1, 3], [0; 0.6; 0]);
  y = gsmbp_run (angles, t, ...
                 [p; a1; p; a2; v; rates([1, 2, 3], a1) \ w0; v; rates([3, 1, 3], a2) \ w0], ...
                 []);
  for i = 1:numel (t)
    R = pose_rotation (x(i, 4:7));
    away1(:, i) = [y(i, 1:3)' - x(i, 1:3)'; (product ([1, 2, 3], y(i, 4:6)) - R)(:); ...
                   rates([1, 2, 3], y(i, 4:6)) * y(i, 16:18)' - x(i, 11:13)'];
    away2(:, i) = [y(i, 7:9)' - x(i, 1:3)'; (product ([3, 1, 3], y(i, 10:12)) - R)(:); ...
                   rates([3, 1, 3], y(i, 10:12)) * y(i, 22:24)' - x(i, 11:13)'];
  end
  gsmbp_check ("orientation: angles about x, y, z move as Euler parameters", away1, 1e-11);
  gsmbp_check ("orientation: angles about z, x, z move as Euler parameters", away2, 1e-11);
  E = @(m, x) sum (m.ene (0, x)(1:2));
  gsmbp_check ("orientation: the same energies, J", E (angles, y(1, :)') - 2 * E (m, x(1, :)'), ...
               1e-12);
end

## M in the speeds w does not depend on the orientation's parameters, whatever their length; q'
## keeps their length; PRJ brings it to 1
function lengths (m)
  [centre, J] = body ();
  rand ("twister", 5);
  [e, u] = deal (rand (4, 1) - 0.5, 2 * rand (6, 1) - 1);
  e /= norm (e);
  R = pose_rotation (e);
  c = R * centre;
  S = @(a) [0, -a(3), a(2); a(3), 0, -a(1); -a(2), a(1), 0];
  M = [1.3 * eye(3), -1.3 * R * S(centre); (-1.3 * R * S(centre))', J - 1.3 * S(centre) ^ 2];
  gsmbp_check ("orientation: mass matrix of a free body", m.mas (0, [1; 2; 3; e]) - M, 1e-15);
  qd = m.kin (0, [1; 2; 3; e], u);
  gsmbp_check ("orientation: e'e stays", e' * qd(4:7), 1e-16);
  dR = @(s) pose_rotation ((e + s * qd(4:7)) / norm (e + s * qd(4:7)));
  K = pose_slope (dR, 0) * R';
  gsmbp_check ("orientation: the rates of the parameters turn the body by w", ...
               [K(3, 2); K(1, 3); K(2, 1)] - R * u(4:6), 1e-12);
  x = m.prj (0, [1; 2; 3; 1.2 * e; u]);
  gsmbp_check ("orientation: PRJ normalizes and leaves the rest", x - [1; 2; 3; e; u], 1e-15);
end

## a top that falls through the horizontal: there the angles about x, y, z are singular; (1/2) k w^2
## + m g l cos(angle) stays
function through_horizontal (parameters, angles)
  k = 0.0007 + 0.5 * 0.08 ^ 2;
  [a0, w0, t] = deal (1.2, 3, linspace (0, 0.5, 26));
  x = gsmbp_run (parameters, t, [cos(a0 / 2); 0; sin(a0 / 2); 0; 0; w0; 0], []);
  angle = unwrap (2 * atan2 (x(:, 3), x(:, 1)));
  level = @(angle, w) k * w .^ 2 / 2 + 0.5 * 9.81 * 0.08 * cos (angle);
  gsmbp_check ("orientation: Euler parameters pass the horizontal", ...
               angle(1) < pi/2 && angle(end) > pi/2);
  gsmbp_check ("orientation: energy on the way, J", level (angle, x(:, 6)) - level (a0, w0), 1e-13);
  gsmbp_check ("orientation: and stay in their plane", x(:, [2, 4, 5, 7]), 1e-14);
  [~, info] = angles.rhs (0, [0; 1.2; 0; 0; 3; 0], []);
  gsmbp_check ("orientation: angles away from the singularity, INFO = 0", info == 0);
  for off = [1e-4, -1e-6]
    [xd, info] = angles.rhs (0, [0; pi/2 + off; 0; 0; 3; 0], []);
    gsmbp_check (sprintf (["orientation: %g rad from the singularity, INFO = 3 and a finite " ...
                           "result"], ...
                          off), info == 3 && all (isfinite (xd)));
  end
  ## the mass matrix is singular in double precision there
  [~, info] = angles.rhs (0, [0; pi/2 + 1e-9; 0; 0; 3; 0], []);
  gsmbp_check ("orientation: 1e-9 rad from the singularity is never silent", ...
               info == 1 || info == 3);
  gsmbp_check ("orientation: the scene says which joints have angles", ...
               isequal (angles.json.angles(:)', {"S"}) && isempty (parameters.json.angles));
  ## just beside the singularity the first and third angle run to opposite ends: steps become small,
  ## and the run says so
  warning ("off", "gsmbp:angles", "local");
  r = gsmbp_simulate (angles, [0.01; a0; 0; 0; w0; 0.2], t, "rtol", 1e-9, "maxsteps", 1e6);
  gsmbp_check ("orientation: a run through it reports how often it was near", ...
               r.stats.angle_singularities > 0);
end

function R = product (axes, a)
  R = eye (3);
  for k = 1:3
    R = R * pose_turn (axes(k), a(k))(1:3, 1:3);
  end
end

## angular velocity in body axes by the rates
function W = rates (axes, a)
  W(:, 3) = double ((1:3)' == axes(3));
  R3 = pose_turn (axes(3), -a(3))(1:3, 1:3);
  W(:, 2) = R3 * double ((1:3)' == axes(2));
  W(:, 1) = R3 * pose_turn (axes(2), -a(2))(1:3, 1:3) * double ((1:3)' == axes(1));
end

## the angles of a rotation by Newton's method
function a = sequence (R, axes, a)
  for k = 1:30
    D = product (axes, a)' * R;
    a += rates (axes, a) \ [D(3, 2) - D(2, 3); D(1, 3) - D(3, 1); D(2, 1) - D(1, 2)] / 2;
  end
end
