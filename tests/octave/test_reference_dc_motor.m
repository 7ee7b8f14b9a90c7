## DC motor with inductance, 24 V switched on at rest.

function test_reference_dc_motor ()
  m = gsmbp_fixture ("case_17a");
  [~, ref, tab] = gsmbp_case ("17a_dc_motor_step");
  gsmbp_check ("dc_motor: states are angle, speed, current", ...
               isequal (m.states(1:2)(:)', {"theta", "theta_d"}) && numel (m.states) == 3);
  x = gsmbp_run (m, tab.t, zeros (3, 1), 24);
  wanted = [tab.theta, tab.omega, tab.i];
  ## 300 steps or so at a tolerance of 1e-13 each
  gsmbp_check ("dc_motor: angle, speed, current", (x - wanted) ./ max (abs (wanted)), 1e-11);
  A = m.jac (0, zeros (3, 1), 24);
  found = A([3, 2], [3, 2]);
  gsmbp_check ("dc_motor: linear model", (found - ne_numbers (ref.values.A)) / 516.7, 1e-14);
  gsmbp_check ("dc_motor: poles", ...
               sort (eig (found)) ./ sort (ne_numbers (ref.values.poles)) - 1, 1e-13);
  still = m.rhs (0, [0; ne_numbers(ref.values.omega_ss); ne_numbers(ref.values.i_ss)], 24);
  gsmbp_check ("dc_motor: steady state", still(2:3) ./ [516; 342], 1e-12);
end
