## Heavy top: spin axis, angular velocity and invariants over 1 s, in Euler parameters and in three
## angles.

function test_reference_heavy_top ()
  [~, ref, tab] = gsmbp_case ("08a_heavy_top");
  w0 = [0; 0; 100] + 2 * [-sin(0.4); 0; cos(0.4)];   # 100 e3 + 2 ez in the axes of the top

  m = gsmbp_fixture ("case_08a");
  gsmbp_check ("heavy_top: four Euler parameters, three speeds", ...
               m.sizes.nq == 4 && m.sizes.nu == 3);
  x0 = [cos(0.2); 0; sin(0.2); 0; w0];
  gsmbp_check ("heavy_top: the scene's start", m.initial - [x0(1:4); 0; 0; 0], 1e-15);
  compare ("heavy_top: Euler parameters", m, gsmbp_run (m, tab.t, x0, []), @by_parameters, tab);
  gsmbp_check ("heavy_top: mass matrix in Euler parameters is the inertia about the pivot", ...
               m.mas (0, x0(1:4)) - diag ([0.0039, 0.0039, 0.0004]), 1e-17);

  m = gsmbp_fixture ("case_08a_angles");
  q0 = [0; 0.4; 0];
  [~, ~, W] = by_angles ([q0; 0; 0; 0]);
  compare ("heavy_top: angles about x, y, z", ...
           m, gsmbp_run (m, tab.t, [q0; W \ w0], []), @by_angles, tab);
end

## e3 and the angular velocity in ground axes from a state, W: angular velocity in body axes by the
## rates (of angles)
function [R, w] = by_parameters (x)
  e = x(1:4);
  v = e(2:4);
  R = (2 * e(1) ^ 2 - 1) * eye (3) + 2 * v * v' + 2 * e(1) ...
      * [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
  w = R * x(5:7);
end

function [R, w, W] = by_angles (x)
  [c, s] = deal (cos (x(1:3)), sin (x(1:3)));
  Rx = [1, 0, 0; 0, c(1), -s(1); 0, s(1), c(1)];
  Ry = [c(2), 0, s(2); 0, 1, 0; -s(2), 0, c(2)];
  Rz = [c(3), -s(3), 0; s(3), c(3), 0; 0, 0, 1];
  R = Rx * Ry * Rz;
  W = [Rz' * Ry' * [1; 0; 0], Rz' * [0; 1; 0], [0; 0; 1]];
  w = R * W * x(4:6);
end

function compare (name, m, x, seen, tab)
  I = diag ([0.0007 + 0.5 * 0.08 ^ 2, 0.0007 + 0.5 * 0.08 ^ 2, 0.0004]);
  for i = 1:rows (x)
    [R, w] = seen (x(i, :)');
    axis(i, :) = R(:, 3);
    omega(i, :) = w;
    L = R * I * R' * w;
    E = m.ene (0, x(i, :)', []);
    kept(i, :) = [E(1) + E(2), L(3), L' * R(:, 3)];
  end
  ## 1 s is 16 turns; steps of some 1e-3 s at 1e-13 each
  gsmbp_check ([name ", spin axis over 1 s"], axis - [tab.e3x, tab.e3y, tab.e3z], 1e-11);
  gsmbp_check ([name ", angular velocity over 1 s, of 100 rad/s"], ...
               (omega - [tab.wx, tab.wy, tab.wz]) / 100, 1e-11);
  gsmbp_check ([name ", energy and two angular momenta"], ...
               kept ./ [tab.energy, tab.Lz, tab.L3] - 1, 1e-11);
end
