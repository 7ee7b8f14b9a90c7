## Tilted cylindrical joint: sliding and swinging over 5 s (closed form: free fall and an elliptic
## function).

function test_reference_cylindrical ()
  m = gsmbp_fixture ("case_11a");
  [~, ref, tab] = gsmbp_case ("11a_cylindrical_tilted");
  gsmbp_check ("cylindrical: displacement first, then angle", ...
               isequal (m.states(:)', {"s", "q", "s_d", "q_d"}));
  x = gsmbp_run (m, tab.t, [0.1; 2.5; 2; 0], []);
  wanted = [tab.z, tab.q, tab.zd, tab.qd];
  gsmbp_check ("cylindrical: motion over 5 s", (x - wanted) ./ max (abs (wanted)), 1e-11);
  period = ne_numbers (ref.period);
  y = gsmbp_run (m, [0, period], [0.1; 2.5; 2; 0], []);
  ## at the end of a period the speed is zero, the angle the first one
  gsmbp_check ("cylindrical: period", [y(end, 2) - 2.5, y(end, 4)], 1e-11);
  xd = m.rhs (0, [0.3; 1.1; -2; 4], []);
  k = 2.5 * 0.12 ^ 2 + 0.02;
  gsmbp_check ("cylindrical: accelerations, closed form", ...
               xd(3:4) - [-9.81 * 0.8; -2.5 * 0.12 * 9.81 * 0.6 * sin(1.1) / k], 1e-13);
end
