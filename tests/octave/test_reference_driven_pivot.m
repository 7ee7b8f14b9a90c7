## Pendulum on a driven block: motion over 2 s, and the force of the drive.

function test_reference_driven_pivot ()
  m = gsmbp_fixture ("case_19a");
  [~, ~, tab] = gsmbp_case ("19a_rheonomic_pivot_pendulum");
  gsmbp_check ("driven_pivot: one multiplier, the drive's", ...
               m.sizes.nlam == 1 && ! isempty (strfind (m.multipliers{1}, "P")));
  y = @(t) 0.05 * [sin(60 * t), 60 * cos(60 * t), -3600 * sin(60 * t)];
  for i = 1:numel (tab.t)
    t = tab.t(i);
    x = [tab.y_pivot(i); tab.theta(i); y(t)(2); tab.thetadot(i)];
    [phi, phit, H] = m.con (t, x(1:2), x(3:4));
    gap(i, :) = [phi, (H * x(3:4) + phit) / 3];
    [ud, lam] = m.acc (t, x, []);
    acceleration(i, :) = ud;
    force(i, 1) = lam;
  end
  gsmbp_check ("driven_pivot: constraint and its rate at the reference states", gap, 1e-14);
  ## sin(60*t) is evaluated at t rounded to double: 60*2 rad have an error of 1e-14 rad
  gsmbp_check ("driven_pivot: acceleration of the block", ...
               (acceleration(:, 1) ...
                  - cell2mat (arrayfun (y, tab.t, "UniformOutput", false))(:, 3)) / 180, 1e-13);
  gsmbp_check ("driven_pivot: angular acceleration", ...
               (acceleration(:, 2) - tab.thetaddot) / max (abs (tab.thetaddot)), 1e-13);
  gsmbp_check ("driven_pivot: force of the drive", (force - tab.lam) / max (abs (tab.lam)), 1e-13);
  x = gsmbp_run (m, tab.t, [0; 2.9; 3; 0], []);
  gsmbp_check ("driven_pivot: motion over 2 s", x(:, 1:2) - [tab.y_pivot, tab.theta], 1e-10);
  gsmbp_check ("driven_pivot: speed over 2 s, rad/s", x(:, 4) - tab.thetadot, 1e-9);
end
