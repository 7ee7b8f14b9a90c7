## Links without mass: the mass matrix of the reduced tree is singular, the motion is not. Coupler
## of a four-bar, cross of a Hooke transmission.

function test_massless ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  m = gsmbp_fixture ("massless_bars");
  angles = @(th) four_bar (th);
  place = @(th) cat (3, pose_turn (3, th), pose_go ([0.6; 0; 0]) * pose_turn (3, angles (th)(3)));
  body = pose_bodies ([0.9, 1.4], [0.1, 0.26; 0, 0; 0, 0], ...
                      {diag([0, 0.006, 0.006]), diag([0, 0.03, 0.03])});
  [four, hooke, rest] = deal ([]);
  for th = [1.1, 2.5, -2, 0.8]
    w = 3;
    turn = th / 2;
    ratio = (sqrt (3) / 2) / (1 - sin (turn) ^ 2 / 4);
    x = [angles(th); turn; atan(sqrt (3) / 2 * tan (turn)); cross_angle(turn); ...
         pose_slope(angles, th) * w; 5; 5 * ratio; 5 * pose_slope(@cross_angle, turn)];
    [phi, phit, H] = m.con (0, x(1:6), x(7:12));
    rest(:, end+1) = [phi; (H * x(7:12) + phit)];
    M = m.mas (0, x(1:6));
    singular = rank (M) < 6;
    [xd, info] = m.rhs (0, x);
    gsmbp_check (sprintf ("massless: singular mass matrix, regular motion (th = %.1f)", th), ...
                 singular && info == 0);
    rest_effort = pose_effort (place, body, [0; -9.81; 0], th, w, 0);
    four(end+1) = xd(7) ...
        + rest_effort / (pose_effort (place, body, [0; -9.81; 0], th, w, 1) - rest_effort);
    ## ratio' by the angle, and (j1 + j2 ratio^2) a + j2 ratio ratio' w^2 = torque
    slope = sqrt (3) / 2 * sin (turn) * cos (turn) / 2 / (1 - sin (turn) ^ 2 / 4) ^ 2;
    hooke(end+1) = xd(10) - (0.8 - 0.05 * ratio * slope * 25) / (0.02 + 0.05 * ratio ^ 2);
  end
  gsmbp_check ("massless: closed positions and speeds", rest, 1e-11);
  gsmbp_check ("massless: four-bar without a coupler's mass, rad/s^2", four, 1e-8);
  gsmbp_check ("massless: Hooke's transmission with its cross, rad/s^2", hooke, 1e-11);
  x = gsmbp_assemble (m, [1.1; -0.7; 1.2; 0; 0; 0; 2; 0; 0; 5; 0; 0], "hold", {"theta", "q1"});
  t = linspace (0, 2, 21);
  r = gsmbp_simulate (m, x, t, "rtol", 1e-11, "atol", 1e-11);
  E = arrayfun (@(i) sum (m.ene (0, r.x(i, :)')(1:2)) - 0.8 * r.x(i, 4), 1:numel (t));
  gsmbp_check ("massless: energy less the work of the drive over 2 s, J", E - E(1), 1e-9);
  gsmbp_check ("massless: shafts keep Hooke's relation", ...
               sin (r.x(:, 5)) .* cos (r.x(:, 4)) - sqrt (3) / 2 * sin (r.x(:, 4)) ...
                 .* cos (r.x(:, 5)), 1e-11);

  ## a link without mass at the end of a chain: nothing tells how it moves, and that is said
  bare = gsmbp_set (gsmbp_fixture ("speeds_pendulum"), "m2", 0, "j2", 0);
  [~, info] = bare.rhs (0, [1; 2; 3; 4], 0);
  gsmbp_check ("massless: the last link of a chain is refused at run time", info == 1);
end

function q = four_bar (th)
  e = [0.6; 0] - 0.25 * [cos(th); sin(th)];
  phi = atan2 (e(2), e(1)) + acos ((0.7 ^ 2 + e' * e - 0.5 ^ 2) / (2 * 0.7 * norm (e)));
  psi = atan2 (0.25 * sin (th) + 0.7 * sin (phi), 0.25 * cos (th) + 0.7 * cos (phi) - 0.6);
  q = [th; phi - th; psi];
end

## the cross turns by q3 about z of shaft 1 until its other axis is across that of shaft 2's own
## direction
function c = cross_angle (turn)
  psi = atan (sqrt (3) / 2 * tan (turn));
  u = pose_turn ([sqrt(3)/2; 1/2; 0], psi)(1:3, 1:3) * [1/2; -sqrt(3)/2; 0];
  v = pose_turn (1, -turn)(1:3, 1:3) * u;
  c = atan2 (v(2), v(1)) - atan2 (-sqrt (3) / 2, 1/2);
end
