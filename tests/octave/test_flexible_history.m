## Flexible links in time: the spin-up of a beam against the equations of one mode as textbooks have
## them, integrated by lsode; energy and momentum, of a beam that flies, too; a mass matrix that
## loses a pivot.

function test_flexible_history ()
  m = gsmbp_fixture ("flexible_spin");
  p = struct ("L", 1.5, "m", 0.9, "EI", 8, "r", 0.2, "jh", 0.3, "T0", 4);
  t = linspace (0, 3, 61);
  run = gsmbp_simulate (m, zeros (4, 1), t, "rtol", 1e-12, "atol", 1e-13);
  lsode_options ("relative tolerance", 1e-12);
  lsode_options ("absolute tolerance", 1e-13);
  lsode_options ("maximum step size", 0.002);
  x = lsode (@(x, t) spin (x, p), zeros (4, 1), t);
  far = max (abs (x));
  gsmbp_check ("spin-up: angle, deflection and their rates, of the largest of each", ...
               (run.x - x) ./ far, 1e-8);
  gsmbp_check ("spin-up: it turns and bends", all (far > [10, 0.05, 5, 0.1]));

  ## the torque does the work and gives the momentum
  [work, energy, momentum] = deal (zeros (numel (t), 1));
  for k = 1:numel (t)
    s = run.x(k, :)';
    energy(k) = sum (m.ene (t(k), s, [])(1:2));
    M = m.mas (t(k), s(1:2));
    momentum(k) = M(1, :) * s(3:4);
  end
  gsmbp_check ("spin-up: energy is the work of the torque", ...
               (energy - energy(1) - p.T0 * run.x(:, 1)) / max (energy), 1e-9);
  gsmbp_check ("spin-up: momentum is the torque times the time", ...
               (momentum - p.T0 * t') / max (momentum), 1e-9);
  flight ();
  bent_too_far ();
  too_fast (gsmbp_set (m, "EI", 8e6));
end

## a mode beyond the stability of rk4: the advice is to leave it out
function too_fast (m)
  lastwarn ("");
  [~, ~] = gsmbp_simulate (m, zeros (4, 1), [0, 0.01], "method", "rk4", "step", 1e-3);
  gsmbp_check (["a mode that is too fast: " lastwarn()], ...
               ! isempty (strfind (lastwarn (), "of blade_1_d): leave that mode of a flexible")));
end

## A beam of the model full that nothing holds, with a body at its end: energy, momentum and moment
## of momentum about the origin, those of its field (independent/fx_field.m), stay to the
## integrator's tolerance.
function flight ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  m = gsmbp_fixture ("flexible_flying");
  k = @(i, EI) EI / 1.2 ^ 3 * fzero (@(b) cos (b) + 1 / cosh (b), ...
                                     (i - 1/2) * pi + [-0.5, 0.5], optimset ("TolX", 0)) ^ 4;
  arm = fx_beam (1.2, 3, [0; 0; 0], "full", {"y", "clamped_free", 1, 1, k(1, 40)
                                             "y", "clamped_free", 2, 2, k(2, 40)
                                             "z", "clamped_free", 1, 3, k(1, 50)});
  x0 = [0; 0; 0; 1; 0; 0; 0; 0.06; -0.01; 0.05; 1; 2; 3; 2; -3; 4; 0.5; 0; -0.5];
  t = linspace (0, 2, 21);
  for rtol = [1e-6, 1e-9, 1e-12]
    run = gsmbp_simulate (m, x0, t, "rtol", rtol, "atol", rtol / 10);
    for k = 1:numel (t)
      all_(:,k) = carried (arm, run.x(k,:)');
    end
    size_ = [all_(1,1); norm(all_(2:4,1)) * ones(3, 1); norm(all_(5:7,1)) * ones(3, 1)];
    gsmbp_check (sprintf (["a beam that flies, tolerance %g: energy, momentum, moment of " ...
                           "momentum, of the size of each"], rtol), ...
                 (all_ - all_(:,1)) ./ size_, 2 * rtol);
  end
  gsmbp_check ("a beam that flies: it bends", max (abs (run.x(:,8:10))) > [0.05, 0.005, 0.04]);
end

## energy, momentum, moment of momentum of the beam of flexible_flying and of the body at its end
function c = carried (arm, x)
  h = 1e-30;
  [p, R, q] = deal (x(1:3), ne_turn (x(4:7)), x(8:10));
  [v, w, qd] = deal (R' * x(11:13), x(14:16), x(17:19));
  ends = fx_sections (arm, 1);
  parts = {fx_field(arm, q + 1i * h * qd, arm.gauss), fx_field(arm, q + 1i * h * qd, ends)};
  turned = ne_turn ([0; 0; 1], parts{2}.angles(3)) * ne_turn ([0; 1; 0], parts{2}.angles(2));
  load_ = parts{2}.place + turned * [1/3; 1/4; -1/5];
  r = [real(parts{1}.place), real(load_)];
  mass = [3 * arm.L * arm.gauss.weight, 2.5];
  u = v + cross (repmat (w, 1, numel (mass)), r) + imag ([parts{1}.place, load_]) / h;
  S = real (turned);
  W = imag (turned) / h * S';
  spin = S * diag ([1, 2, 2.5]) * S' * (w + [W(3,2); W(1,3); W(2,1)]);
  energy = sum (mass .* sum (u .^ 2)) / 2 + spin' * (w + [W(3,2); W(1,3); W(2,1)]) / 2 ...
           + sum ([arm.modes.stiffness] .* q' .^ 2) / 2;
  at = p + R * r;
  momentum = mass .* (R * u);
  c = [energy; sum(momentum, 2); sum(cross (at, momentum), 2) + R * spin];
end

## a beam that nothing holds in the model second: the mass matrix loses a pivot, which is said
function bent_too_far ()
  m = gsmbp_fixture ("flexible_free");
  for q = [0.01, 0.3]
    lost = min (eig (m.mas (0, [0; 0; 0; q]))) <= 0;
    [~, info] = m.fwd (0, [0; 0; 0; q], zeros (4, 1), [], zeros (4, 1));
    gsmbp_check (sprintf ("a free beam bent by %g: INFO says whether a pivot is lost", q), ...
                 [lost, info] == (q > 0.1));
  end
  said = "";
  try
    gsmbp_simulate (m, [0; 0; 0; 0.3; zeros(4, 1)], [0, 1]);
  catch problem
    said = problem.message;
  end
  gsmbp_check ("a free beam bent too far: the advice", ...
               ! isempty (strfind (said, "that nothing holds is bent too far: take")));
end

## x = [theta; q; theta'; q'] of a beam with one clamped-free mode, hub of radius r
function xd = spin (x, p)
  [b1, c1, d11, e11, k11] = deal (0.7829917560396258, 0.5688257437099108, 1.193336374108256, ...
                                  1.570878189994250, 12.36236336832619);
  J = p.jh + p.m * (p.L ^ 2 / 3 + p.L * p.r + p.r ^ 2);
  c = p.m * p.L * (c1 + p.r / p.L * b1);
  k = p.EI / p.L ^ 3 * k11;
  less = p.m - p.m * (d11 + p.r / p.L * e11);      # m - D
  [q, w, u] = deal (x(2), x(3), x(4));
  A = [J + less * q ^ 2, c; c, p.m];
  xd = [w; u; A \ [p.T0 - 2 * less * q * u * w; -(k - less * w ^ 2) * q]];
end
