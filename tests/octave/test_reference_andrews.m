## Andrews' squeezer: motion over 0.03 s against 27 digits, accelerations and forces in the three
## pins at the end of it, energy.

function test_reference_andrews ()
  m = gsmbp_fixture ("case_04");
  [~, ref, tab] = gsmbp_case ("04_andrews_squeezer");
  names = {"beta", "theta", "gamma", "delta", "phi", "epsilon", "Omega"};
  gsmbp_check ("andrews: coordinates in the order of the scene", ...
               isequal (m.coordinates(:)', names));
  q = cell2mat (cellfun (@(n) tab.(n), names, "UniformOutput", false));
  u = cell2mat (cellfun (@(n) tab.(["d_" n]), names, "UniformOutput", false));
  gsmbp_check ("andrews: a pin has two rows, in the plane", ...
               isequal (m.multipliers(:)', {"E3.x", "E3.y", "E4.x", "E4.y", "E6.x", "E6.y"}));
  for i = 1:rows (q)
    [phi, phit, H] = m.con (0, q(i, :)', u(i, :)');
    gap(i, :) = phi;
    rate(i, :) = H * u(i, :)' + phit;
    E = m.ene (0, [q(i, :), u(i, :)]', []);
    energy(i, 1) = E(1) + E(2) - 0.033 * q(i, 1);
    scale(i, 1) = E(1);
  end
  ## lengths of 0.1 m; speeds of 1400 rad/s with arms of 0.03 m
  gsmbp_check ("andrews: loops closed at the reference positions, m", gap, 1e-15);
  gsmbp_check ("andrews: speeds keep them closed, m/s", rate, 1e-13);
  gsmbp_check ("andrews: energy less the work of the drive, over the largest kinetic energy", ...
               (energy - energy(1)) / max (scale), 1e-13);

  ## final accelerations from the 32-digit state, rounded to double
  final = @(field) cellfun (@(n) ne_numbers (ref.final.(field).(n)), names)';
  [ud, lam] = m.acc (0, [final("q"); final("qd")], []);
  lam_wanted = ne_numbers (ref.final.lam);
  ## the mechanism stiffens a rounded state: 4e5 rad/s^2 of 2e6 rad^2/s^2 times the slopes of the
  ## configuration
  gsmbp_check ("andrews: accelerations at t = 0.03", ...
               (ud - final("qdd")) / max (abs (final("qdd"))), ...
               1e-12);
  gsmbp_check ("andrews: pin forces at t = 0.03", ...
               (lam - lam_wanted) / max (abs (lam_wanted)), 1e-12);

  x = gsmbp_run (m, tab.t, [q(1, :), u(1, :)]', []);
  ## angles reach 16 rad; near the dead centres of the loop an error grows a hundredfold
  gsmbp_check ("andrews: motion over 0.03 s, rad", x(:, 1:7) - q, 1e-10);
  gsmbp_check ("andrews: speeds over 0.03 s, over the largest", ...
               (x(:, 8:14) - u) / max (abs (u(:))), ...
               1e-10);
end
