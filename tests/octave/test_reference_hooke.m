## Hooke's transmission: the closed form over 2 s; three of the four rows of the universal joint
## vanish and are taken out, with a reason.

function test_reference_hooke ()
  m = gsmbp_fixture ("case_09a");
  [~, ~, tab] = gsmbp_case ("09a_hooke_joint");
  gsmbp_check ("hooke: one row is left", isequal (m.multipliers(:)', {"U.m"}));
  removed = {m.json.removed.row};
  gsmbp_check ("hooke: x, y, z are reported as taken out", ...
               isequal (sort (removed(:)'), {"U.x", "U.y", "U.z"}));
  gsmbp_check ("hooke: each with a reason", cellfun (@numel, {m.json.removed.reason}) > 5);
  ratio = (sqrt (3) / 2) ./ (1 - sin (tab.theta) .^ 2 / 4);
  for i = 1:numel (tab.t)
    x = [tab.theta(i); tab.psi(i); tab.thetadot(i); tab.psidot(i)];
    [phi, phit, H] = m.con (0, x(1:2), x(3:4));
    gap(i, :) = [phi, (H * x(3:4) + phit) / x(3)];
    found(i, 1) = -H(1) / H(2);
    xd = m.rhs (0, x, []);
    acceleration(i, 1) = xd(3);
  end
  gsmbp_check ("hooke: closed at the reference positions and speeds", gap, 1e-13);
  gsmbp_check ("hooke: ratio of the speeds", [found - ratio; found - tab.ratio], 1e-13);
  gsmbp_check ("hooke: acceleration of the input shaft", ...
               (acceleration - tab.thetaddot) / max (abs (tab.thetaddot)), 1e-13);
  x = gsmbp_run (m, tab.t, [0; 0; 5; 5 * sqrt(3) / 2], []);
  gsmbp_check ("hooke: motion over 2 s, rad", x(:, 1:2) - [tab.theta, tab.psi], 1e-10);
  gsmbp_check ("hooke: speeds over 2 s, rad/s", x(:, 3:4) - [tab.thetadot, tab.psidot], 1e-9);
end
