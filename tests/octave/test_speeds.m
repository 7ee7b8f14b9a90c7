## Speeds of the user: a top's angular velocity from its angles, a double pendulum with the links'
## own rates.

function test_speeds ()
  body ();
  pendulum ();
end

## in w the mass matrix is the inertia about the pivot, and the motion that of Euler's equations
function body ()
  m = gsmbp_fixture ("speeds_body");
  plain = gsmbp_fixture ("case_08a_angles");
  parameters = gsmbp_fixture ("case_08a");
  gsmbp_check ("speeds: the user's names", isequal (m.speeds(:)', {"u1", "u2", "u3"}));
  J = diag ([0.0007 + 0.5 * 0.08 ^ 2, 0.0007 + 0.5 * 0.08 ^ 2, 0.0004]);
  rand ("twister", 11);
  for trial = 1:10
    q = [2 * pi; 2; 2 * pi] .* (rand (3, 1) - 0.5);
    w = 20 * (rand (3, 1) - 0.5);
    [c, s] = deal (cos (q), sin (q));
    W = [c(2) * c(3), s(3), 0; -c(2) * s(3), c(3), 0; s(2), 0, 1];
    mass(trial, :) = (m.mas (0, q) - J)(:);
    rates(trial, :) = W * m.kin (0, q, w) - w;
    xd = m.rhs (0, [q; w]);
    ## R' z g: gravity in body axes
    down = -9.81 ...
        * [s(1) * s(3) - c(1) * s(2) * c(3); s(1) * c(3) + c(1) * s(2) * s(3); c(1) * c(2)];
    euler(trial, :) = J * xd(4:6) + cross (w, J * w) - cross ([0; 0; 0.08], 0.5 * down);
    energy(trial, :) = m.ene (0, [q; w]) - plain.ene (0, [q; W \ w]);
  end
  gsmbp_check ("speeds: mass matrix of the top", mass, 1e-17);
  gsmbp_check ("speeds: rates of the angles, rad/s", rates, 1e-13);
  gsmbp_check ("speeds: Euler's equations, N m", euler, 1e-14);
  gsmbp_check ("speeds: energies as with the angles' rates, J", energy, 1e-13);
  t = linspace (0, 0.5, 26);
  w0 = [0; 0; 100] + 2 * [-sin(0.4); 0; cos(0.4)];
  x = gsmbp_run (m, t, [0; 0.4; 0; w0], []);
  y = gsmbp_run (plain, t, [0; 0.4; 0; [cos(0.4), 0, 0; 0, 1, 0; sin(0.4), 0, 1] \ w0], []);
  z = gsmbp_run (parameters, t, [cos(0.2); 0; sin(0.2); 0; w0], []);
  gsmbp_check ("speeds: the same angles as with their rates", x(:, 1:3) - y(:, 1:3), 1e-10);
  gsmbp_check ("speeds: the same angular velocity as with Euler parameters, of 100 rad/s", ...
               (x(:, 4:6) - z(:, 5:7)) / 100, 1e-11);
end

## M = [m1 c1^2 + j1 + m2 l^2, m2 l c2 cos(q2); ., m2 c2^2 + j2]; forces of friction, of the drive
## and of gravity on the links' own angles
function pendulum ()
  m = gsmbp_fixture ("speeds_pendulum");
  [g, l, c1, c2, m1, m2, j1, j2] = deal (9.81, 0.5, 0.2, 0.3, 1.2, 0.8, 0.03, 0.02);
  M = @(q2) [m1 * c1^2 + j1 + m2 * l^2, m2 * l * c2 * cos(q2); m2 * l * c2 * cos(q2), ...
             m2 * c2^2 + j2];
  h = m2 * l * c2;
  bias = @(q, w) [-h * sin(q(2)) * w(2)^2 + (m1 * c1 + m2 * l) * g * sin(q(1)) + 0.02 * w(1) ...
      - 0.01 * (w(2) - w(1)); ...
                  h * sin(q(2)) * w(1)^2 + m2 * c2 * g * sin(q(1) + q(2)) + 0.01 * (w(2) - w(1))];
  [q, w, wd, tau] = deal ([0.7; -1.9], [2; -3], [5; 1], 0.4);
  gsmbp_check ("speeds: double pendulum, mass matrix", m.mas (0, q) - M (q(2)), 1e-15);
  gsmbp_check ("speeds: double pendulum, bias", m.bia (0, q, w, tau) - bias (q, w) + [0; tau], ...
               1e-14);
  gsmbp_check ("speeds: double pendulum, inverse dynamics", ...
               m.inv (0, q, w, wd, tau) - M (q(2)) * wd - bias (q, w) + [0; tau], 1e-14);
  xd = m.rhs (0, [q; w], tau);
  gsmbp_check ("speeds: double pendulum, state space", ...
               xd - [w(1); w(2) - w(1); M(q(2)) \ ([0; tau] - bias (q, w))], 1e-12);
end
