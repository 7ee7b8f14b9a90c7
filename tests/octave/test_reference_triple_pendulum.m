## Spatial triple pendulum with skew axes: accelerations and energy at the reference states, motion
## over 5 s.

function test_reference_triple_pendulum ()
  m = gsmbp_fixture ("case_07c");
  [~, ~, tab] = gsmbp_case ("07c_spatial_triple_pendulum");
  x = [tab.q1, tab.q2, tab.q3, tab.d_q1, tab.d_q2, tab.d_q3];
  wanted = [tab.dd_q1, tab.dd_q2, tab.dd_q3];
  for i = 1:rows (x)
    xd = m.rhs (0, x(i, :)', []);
    ud(i, :) = xd(4:6);
    E = m.ene (0, x(i, :)', []);
    energy(i, 1) = E(1) + E(2);
  end
  gsmbp_check ("triple_pendulum: accelerations, 26 states", ...
               (ud - wanted) / max (abs (wanted(:))), 1e-13);
  gsmbp_check ("triple_pendulum: energy", (energy - tab.energy) / max (abs (tab.energy)), 1e-13);
  found = gsmbp_run (m, tab.t, x(1, :)', []);
  ## measured 5e-13 and 3e-12; the motion is irregular, another machine's rounding may grow to some
  ## ten times that
  gsmbp_check ("triple_pendulum: motion over 5 s, rad", found(:, 1:3) - x(:, 1:3), 1e-11);
  gsmbp_check ("triple_pendulum: speeds over 5 s, rad/s", found(:, 4:6) - x(:, 4:6), 1e-10);
end
