## Nut on a screw: mass, gravity, acceleration, and the height after 1 s.

function test_reference_screw_nut ()
  m = gsmbp_fixture ("case_10a");
  [~, ref] = gsmbp_case ("10a_helical_nut");
  wanted = @(field) ne_numbers (ref.values.(field));
  gsmbp_check ("screw_nut: mass matrix", m.mas (0, 0.3) / wanted("mass_matrix") - 1, 1e-14);
  free = gsmbp_set (m, "tau", 0);
  gsmbp_check ("screw_nut: torque of gravity", ...
               free.bia (0, 0.3, 0) / wanted("gravity_torque") - 1, 1e-14);
  xd = m.rhs (0, [0.7; 3], []);
  gsmbp_check ("screw_nut: acceleration, at any angle and speed", xd(2) / wanted("qdd") - 1, 1e-13);
  x = gsmbp_run (m, [0, 1], [0; 0], []);
  gsmbp_check ("screw_nut: angle after 1 s", x(end, 1) / wanted("q_at_1s") - 1, 1e-12);
  ## height of the mass centre, the last point of the nut in the skeleton
  height = (m.ske (0, x(end, 1)) - m.ske (0, 0))(3, end);
  gsmbp_check ("screw_nut: height after 1 s", height / wanted("z_at_1s") - 1, 1e-12);
  E = m.ene (0, [20 * pi; 0], []);
  E0 = m.ene (0, [0; 0], []);
  gsmbp_check ("screw_nut: ten turns lift it by 50 mm", ...
               (E(2) - E0(2)) / (1.5 * 9.81 * 0.05) - 1, 1e-14);
end
