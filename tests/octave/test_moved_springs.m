## Springs whose rest holds an input or the time, by hand: accelerations, Jacobians, reaction, and
## the energy of a run, in which what moves the rest gives power.

function test_moved_springs ()
  m = gsmbp_fixture ("moved_springs");
  [t, x, v] = deal (0.3, [0.25; 0.65; 0.4; -0.3], 0.02);
  gsmbp_check ("accelerations", m.rhs (t, x, v) - by_hand (m.par, t, x, v), 1e-11);
  slope = @(f, z) (f (z + 1e-6) - f (z - 1e-6)) / 2e-6;
  [A, B] = m.jac (t, x, v);
  for k = 1:4
    e = (1:4)' == k;
    differences(:,k) = slope (@(s) m.rhs (t, x + s * e, v), 0);
  end
  gsmbp_check ("Jacobian by the states", A - differences, 1e-5);
  gsmbp_check ("Jacobian by the input", B - slope (@(s) m.rhs (t, x, s), v), 1e-5);
  gsmbp_check ("force on the road [N]", m.out (t, x, v) - tyre (m.par, x, v), 1e-9);
  audited (m);
end

function f = tyre (p, x, v)
  f = p.kt * (p.lt + v - x(1));
end

function xd = by_hand (p, t, x, v)
  coil = p.ks * (x(2) - x(1) - p.ls - p.a * sin (p.w * t)) + p.cs * (x(4) - x(3));
  xd = [x(3:4); (tyre(p, x, v) + coil) / p.mu - p.g; -coil / p.ms - p.g];
end

function audited (m)
  [t, start] = deal ((0:0.01:1)', [0.28; 0.7; 0; 0]);
  road = gsmbp_plan ("table", t, 0.02 * sin (5 * t), 3);
  r = gsmbp_simulate (m, start, t, "input", road, "audit", 100);
  gsmbp_check ("energy left over of what passed", r.audit.error, 1e-9);
  gsmbp_check ("... and some did [J]", r.audit.passed(end) > 10);
end
