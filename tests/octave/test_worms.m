## Gears that lock themselves: efficiency 1/2, where the back efficiency is 0; two worms in an arm
## and beside each other; a worm with stops and friction on its wheel. Tooth torques by hand: what
## arrives at a mesh is x/ef where the pinion drives, eb*x where the gear does.

function test_worms ()
  half ();
  arm ();
  belt ();
  stopped ();
end

## ef = 1/2, eb = 0: a load that pushes the way the gear slides reaches the motor not at all
function half ()
  m = gsmbp_set (gsmbp_fixture ("gear_worm"), "ef", 0.5, "eb", 0);
  p = m.par;
  n = 40;
  cases = [1 5 -20; 1 0.5 300; -1 -5 20; -1 -0.5 -300; 1 0 -20; 1 0 300; -1 2 -20; -1 2 -900];
  for c = cases'
    [h, T, L] = deal (c(1), c(2), c(3));
    a = (n * T / 2 + L) / (p.Jg + n ^ 2 * p.Jw / 2);     # x = (T - n*J*a)/2
    if (h * (T - n * p.Jw * a) < 0)
      a = T / (n * p.Jw);                                # x + loss = 0
      gsmbp_check ("half: the load pushes", h * (p.Jg * a - L) < 0);
    end
    [xd, info] = m.rhs (0, [0; h], [h; T; L]);
    gsmbp_check (sprintf ("half: h %g, T %g, L %g", c), xd(2) - a, 1e-12 * max (1, abs (a)));
    gsmbp_check ("half: INFO", info == 0);
  end
  for T = [1, -1] * 1e-3
    g = m.evt (0, [0; 0], [0; T; 100], 0);
    gsmbp_check ("half: without torque it just holds", sign (g) == -sign (T));
  end
  for v = [-2, 3, 0; 50, -100, 50]
    s = gsmbp_simulate (m, [0; 2], linspace (0, 1, 6), "input", v, "audit", 1, "rtol", 1e-11, ...
                        "atol", 1e-11);
    gsmbp_check ("half: energy of the run", s.audit.error, 1e-9);
  end
end

## accelerations of the arm; each column of a: one solution
function a = arm_by_hand (p, q2, u, h, T, L)
  n = [40; 30];
  [c, s] = deal (p.l1 * p.l2 * cos (q2), p.m2 * p.l1 * p.l2 * sin (q2));
  M = [p.m1 * p.l1 ^ 2 + p.m2 * (p.l1 ^ 2 + p.l2 ^ 2 + 2 * c), p.m2 * (p.l2 ^ 2 + c); ...
       p.m2 * (p.l2 ^ 2 + c), p.m2 * p.l2 ^ 2];
  b = s * [-2 * u(1) * u(2) - u(2) ^ 2; u(1) ^ 2];
  a = solutions (M, -diag (n), diag (n .* [p.J1; p.J2]), h, [p.ef1; p.ef2], [p.eb1; p.eb2], ...
                 L - b, T);
end
## M*a + N*x = f, T - J*a = x/ef or eb*x
function a = solutions (M, N, J, h, ef, eb, f, T)
  [a, k] = deal ([], rows (M));
  for s = [1 1 -1 -1; 1 -1 1 -1]
    e = 1 ./ ef;
    e(s .* h < 0) = eb(s .* h < 0);
    z = [M, N; J, diag(e)] \ [f; T];
    if (all (s .* z(k+1:end) > 0))
      a(:, end + 1) = z(1:k);
    end
  end
end

function arm ()
  fixed = gsmbp_fixture ("gear_two_worms");
  rand ("twister", 3);
  found = zeros (1, 3);
  for k = 1:400
    if (mod (k, 10) == 1)
      b = -rand (1, 2) .* (rand (1, 2) < 0.7);
      m = gsmbp_set (fixed, "J1", 10 ^ (-4 + 2 * rand), "J2", 10 ^ (-4 + 2 * rand), "eb1", b(1), ...
                     "eb2", b(2), "ef1", 0.3 + 0.2 * rand, "ef2", 0.3 + 0.2 * rand);
    end
    x = [0.3; 6 * rand; 4 * rand(2, 1) - 2];
    [h, T, L] = deal (sign (x(3:4)), 4 * rand (2, 1) - 2, 200 * rand (2, 1) - 100);
    a = arm_by_hand (m.par, x(2), x(3:4), h, T, L);
    [xd, info] = m.rhs (0, x, inputs_of (m, "A.mode", h(1), "B.mode", h(2), "MA.effort", T(1), ...
      "MB.effort", T(2), "LA.effort", L(1), "LB.effort", L(2)));
    found(1 + min (2, columns (a)))++;
    if (columns (a) != 1)
      gsmbp_check ("arm: none or two solutions are reported", info == 4);
    elseif (info == 0)
      gsmbp_check ("arm: two worms", xd(3:4) - a, 1e-12 * max (1, norm (a)));
    end
  end
  gsmbp_check ("arm: states with none, one, two solutions", found > [10 100 10]);
  derived (fixed);
  x = [0; 0.5; 1; -1];
  for c = [2 2 -10 0; 0 0 30 5; 0.5 -0.3 -10 1; -2 -2 40 0; 4 -3 0 0]'
    v = inputs_of (fixed, "MA.effort", c(1), "MB.effort", c(2), "LA.effort", c(3), ...
                   "LB.effort", c(4));
    s = gsmbp_simulate (fixed, x, linspace (0, 1, 5), "input", v, "audit", 1, "rtol", 1e-11, ...
                        "atol", 1e-11);
    gsmbp_check ("arm: energy of the run", s.audit.error, 1e-9);
  end
end

## derivatives beside differences; many runs as one by one
function derived (m)
  x = [0.3; 0.8; 1.2; -0.7];
  v = inputs_of (m, "A.mode", 1, "B.mode", -1, "MA.effort", 2, "MB.effort", 0.5, "LB.effort", 20);
  [A, P] = deal (m.jac (0, x, v), m.rhp (0, x, v));
  for k = 1:4
    h = 1e-5 * ((1:4)' == k);
    d = (m.rhs (0, x + h, v) - m.rhs (0, x - h, v)) / 2e-5;
    gsmbp_check ("arm: derivative by a state", norm (A(:, k) - d), 1e-7 * norm (A));
  end
  for k = {"m2", "J1"; 1, 2}
    h = 1e-5 * m.par.(k{1});
    d = (gsmbp_set (m, k{1}, m.par.(k{1}) + h).rhs (0, x, v) ...
         - gsmbp_set (m, k{1}, m.par.(k{1}) - h).rhs (0, x, v)) / (2 * h);
    gsmbp_check (["arm: derivative by " k{1}], norm (P(:, k{2}) - d), 1e-7 * norm (d));
  end
  o = {"input", inputs_of(m, "MA.effort", 2, "MB.effort", 2), "rtol", 1e-11, "atol", 1e-11};
  starts = [0 0.5 1 -1; 0.1 -0.4 -1 2];
  many = gsmbp_ensemble (m, [], [0 0.3 0.6], o{:}, "starts", starts, "lanes", true);
  gsmbp_check ("arm: in lanes", many.lanes);
  for k = 1:2
    one = gsmbp_simulate (m, starts(k, :), [0 0.3 0.6], o{:});
    gsmbp_check ("arm: many runs as one", norm (many.x(:, :, k) - one.x) / norm (one.x), 1e-8);
  end
end

## beside each other on a rigid belt: a worm and another gear; two worms jam each other
function belt ()
  two = gsmbp_fixture ("gear_belt");
  m = gsmbp_set (two, "ef1", 0.45, "eb1", -0.2, "ef2", 0.8, "eb2", 0.7);
  p = m.par;
  n = [40; 30 * p.k];
  rand ("twister", 4);
  for k = 1:40
    w = sign (rand - 0.5) * (0.1 + rand);
    [T, L] = deal (4 * rand (2, 1) - 2, 200 * rand - 100);
    a = solutions (p.I1 + p.I2 * p.k ^ 2, -n', n .* [p.J1; p.J2], sign (w), [p.ef1; p.ef2], ...
                   [p.eb1; p.eb2], L, T);
    [xd, info] = m.rhs (0, [0; 0; w; p.k * w], inputs_of (m, "A.mode", sign (w), "B.mode", ...
      sign (w), "MA.effort", T(1), "MB.effort", T(2), "LA.effort", L));
    gsmbp_check ("belt: one solution", [columns(a) == 1, info == 0]);
    gsmbp_check ("belt: worm and gear", xd(3) - a, 1e-11 * max (1, abs (a)));
  end
  for c = [2 2 -10; 0 0 30; 0.5 -0.3 -10; -2 -2 40]'
    v = inputs_of (m, "MA.effort", c(1), "MB.effort", c(2), "LA.effort", c(3));
    s = gsmbp_simulate (m, [0; 0; 1; p.k], linspace (0, 1, 5), "input", v, "audit", 1, ...
                        "rtol", 1e-11, "atol", 1e-11);
    gsmbp_check ("belt: energy of the run", s.audit.error, 1e-9);
  end
  text = gsmbp_complaint (@() gsmbp_simulate (two, [0; 0; 1; p.k], [0 1], "input", ...
                                              inputs_of (two, "MA.effort", 1)));
  gsmbp_check ("belt: two worms jam", ! isempty (strfind (text, "the mesh of A, B jams")));
end

## at a stop, or where friction sticks, the gear holds and loses nothing; it locks itself elsewhere
function stopped ()
  m = gsmbp_fixture ("gear_stop");
  x = [0.4; 0];
  at = @(s, g, f, T, L) inputs_of (m, "S.mode", s, "G.mode", g, "F.mode", f, "M.effort", T, ...
                                   "L.effort", L);
  for c = [1 0 0; 1 1 0; 1 1 1; 1 0 1]'
    v = at (c(1), c(2), c(3), 3, 7);
    [xd, info] = m.rhs (0, x, v);
    gsmbp_check ("stop: rests", [xd(2) == 0, info == 0]);
  end
  ## the stop takes the torque of motor and load, less that of sliding friction
  g = m.evt (0, x, at (1, 0, 1, 3, 7), [1; 0; 1]);
  gsmbp_check ("stop: what it holds", g(1) - (40 * 3 + 7 - 5), 1e-10);
  o = {"rtol", 1e-11, "atol", 1e-11, "audit", 1};
  s = gsmbp_simulate (m, [0; 1], linspace (0, 1, 5), "input", at (0, 0, 0, 3, 10), o{:});
  gsmbp_check ("stop: reached and held", s.x(end, :) - [0.4, 0], 1e-10);
  x = s.x(end, :)';
  s = gsmbp_simulate (m, x, linspace (0, 1, 5), "input", at (0, 0, 0, 0, -100), o{:});
  gsmbp_check ("stop: no load turns the worm back", s.x(end, :) - [0.4, 0], 1e-10);
  s = gsmbp_simulate (m, x, linspace (0, 1, 5), "input", at (0, 0, 0, -3, 10), o{:});
  gsmbp_check ("stop: the motor does", s.x(end, :) - [-0.5, 0], 1e-10);
end
