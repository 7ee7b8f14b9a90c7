## Four-bar: accelerations and pin force at the reference states, motion over 3 s, linear model
## about rest.

function test_reference_four_bar ()
  m = gsmbp_fixture ("case_03a");
  [~, ref, tab] = gsmbp_case ("03a_fourbar");
  q = [tab.theta, tab.phi_coupler - tab.theta, tab.psi_rocker];
  for i = 1:rows (q)
    [~, ~, H] = m.con (0, q(i, :)', zeros (3, 1));
    u = [tab.omega(i); -H(:, 2:3) \ H(:, 1) * tab.omega(i)];
    xd = m.rhs (0, [q(i, :)'; u], 0);
    y = m.out (0, [q(i, :)'; u], 0);
    alpha(i, 1) = xd(4);
    pin(i, :) = y;
    E = m.ene (0, [q(i, :)'; u], 0);
    energy(i, 1) = E(1) + E(2);
    if (i == 1)
      x0 = [q(1, :)'; u];
    end
  end
  gsmbp_check ("four_bar: crank acceleration, 31 states", ...
               (alpha - tab.alpha) / max (abs (tab.alpha)), ...
               1e-13);
  force = [tab.lam_x, tab.lam_y];
  gsmbp_check ("four_bar: pin force on the rocker", ...
               (pin(:, 1:2) - force) / max (abs (force(:))), 1e-13);
  gsmbp_check ("four_bar: energy", (energy - tab.energy) / max (abs (tab.energy)), 1e-13);

  x = gsmbp_run (m, tab.t, x0, 0);
  ## the free motion multiplies an error made at the start by a few hundred over 3 s; the integrator
  ## works at 1e-13 a step
  gsmbp_check ("four_bar: motion over 3 s, rad", x(:, 1:3) - q, 1e-9);
  gsmbp_check ("four_bar: crank speed over 3 s, rad/s", x(:, 4) - tab.omega, 1e-8);
  linear (m, ref.linearization);
end

## dq = t dtheta on the constraint: A of the whole state space, reduced to (dtheta, domega)
function linear (m, ref)
  number = @(field) ne_numbers (ref.(field));
  q = [number("theta_eq"); number("phi_eq") - number("theta_eq"); number("psi_eq")];
  [~, ~, H] = m.con (0, q, zeros (3, 1));
  tangent = [1; -H(:, 2:3) \ H(:, 1)];
  [A, B] = m.jac (0, [q; zeros(3, 1)], 0);
  lift = blkdiag (tangent, tangent);
  reduced = (A * lift)([1, 4], :);
  wanted = number("A");
  gsmbp_check ("four_bar: at rest", m.rhs (0, [q; zeros(3, 1)], 0), 1e-13);
  gsmbp_check ("four_bar: linear model A", (reduced - wanted) / max (abs (wanted(:))), 1e-13);
  gsmbp_check ("four_bar: linear model B", ...
               (B([1, 4]) - number("B")) / max (abs (number("B"))), 1e-13);
  gsmbp_check ("four_bar: natural frequency", ...
               sqrt (-reduced(2, 1)) / number("natural_frequency_rad_s") - 1, 1e-13);
end
