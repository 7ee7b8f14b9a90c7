## Controllers that calculate with the equations of motion, through loops and drives: a five-bar on
## a geared motor and an ideal drive.  Inputs against those of INL and of the motor's own equations,
## errors against their linear equation, impedance of coordinates and of the hand against springs; a
## tool in space; starts without a bump; what is refused.

function test_model_loops ()
  m = gsmbp_fixture ("control_fivebar");
  e = at_rest (m);
  computed_torque (m, e);
  feedforward (m, e);
  impedance (m, e);
  hand (m, e);
  tool ();
  refused (m);
end

## the start with its loops closed, and the inputs that hold it
function e = at_rest (m)
  q = gsmbp_assemble (m, m.initial(1:4))(1:4);
  one = [q, zeros(4, 3)];
  [v, ~, xa] = m.cmx (0, one, zeros (m.sizes.nx, 1)(9:end));
  e = struct ("x", [q; zeros(4, 1); xa], "v", v);
end

function mc = with (m, c)
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
end

function computed_torque (m, e)
  c = gsmbp_model_control (m, "computed torque", "Kp", 400, "Kd", 40, "Ki", 1, "period", 5e-4, ...
                           "trim", e, "delay", 2e-4);
  mc = with (m, c);
  gsmbp_check ("computed torque: the inputs of each coordinate's drive", ...
               isequal (c.driven, {"D1.v"; "t2"}));
  gsmbp_check ("computed torque: it starts with the inputs that hold it", c.u0 - e.v([4, 1]), ...
               1e-12);
  r = gsmbp_simulate (mc, e.x, [0, 0.2]);
  gsmbp_check ("computed torque: at rest nothing moves", r.x - e.x', 1e-12);
  gsmbp_check ("... from the first sample", r.samples.v(1,[4, 1])' - e.v([4, 1]), 1e-12);
  plan = gsmbp_plan ("quintic", [e.x(1), 2.3; e.x(3), 0.9], [0, 1]);
  x0 = e.x;
  x0(1) += 0.05;
  x0(1:4) = gsmbp_assemble (m, x0(1:4), "hold", {"q1", "q2"})(1:4);
  t = (0:0.05:1)';
  r = gsmbp_simulate (mc, x0, t, "input", gsmbp_model_control (mc, "references", plan));
  wanted = ppval (plan, t')';
  gsmbp_check ("computed torque: e'' + 40 e' + 400 e = 0, of the error at the start", ...
               (r.x(:,1) - wanted(:,1)) / 0.05 - (1 + 20 * t) .* exp (-20 * t), 0.02);
  gsmbp_check ("... the other coordinate stays on its way [rad]", r.x(:,3) - wanted(:,2), 1e-4);
  first_inputs (m, x0, plan, r);
end

## the first sample (there at the second, it is late) against INL, and against the motor's equation
function first_inputs (m, x0, plan, r)
  one = zeros (4, 4);
  one(:,1) = x0(1:4);
  one([1, 3],3) = ppval (ppder (ppder (plan)), 0) + 400 * (ppval (plan, 0) - x0([1, 3]));
  one = m.clo (0, one);
  tau = m.inl (0, one(:,1), one(:,2), one(:,3), zeros (m.sizes.nv, 1));
  gsmbp_check ("computed torque: the first effort of the drive is that of INL [N m]", ...
               r.samples.v(2,1) - tau(2), 1e-11);
  gsmbp_check ("computed torque: the first voltage, by the motor's own equations [V]", ...
               r.samples.v(2,4) - 1.2 * tau(1) / (20 * 0.062), 1e-11);
end

function feedforward (m, e)
  [Kp, Kd] = deal ([80; 100], [4; 5]);
  c = gsmbp_model_control (m, "feedforward", "Kp", Kp, "Kd", Kd, "period", 5e-4, "trim", e, ...
                           "limits", [60; 40]);
  mc = with (m, c);
  plan = gsmbp_plan ("septic", [e.x(1), 2.3; e.x(3), 0.9], [0, 0.4]);
  law = gsmbp_model_control (mc, "references", plan);
  r = gsmbp_simulate (mc, e.x, [0, 0.1, 0.2, 0.4, 1], "input", law);
  miss = ppval (plan, min (r.t', 0.4))' - r.x(:,[1, 3]);
  gsmbp_check ("feedforward: on its way [rad]", miss, 2e-3);
  wanted = gsmbp_inverse (m, plan, 0.1, "guess", e.x(1:4));
  v = wanted.v([4, 1]) + Kp' .* miss(2,:) + Kd' .* (wanted.u([1, 3]) - r.x(2,[5, 7]));
  gsmbp_check ("feedforward: inputs of the motion, the inductance in them", ...
               r.samples.v(201,[4, 1]) - v, 1e-9);
  r = gsmbp_simulate (gsmbp_set (mc, "l2", 0.3), closed (gsmbp_set (m, "l2", 0.3)), [0, 0.01], ...
                      "input", [0; 0; pi; 0; zeros(6, 1)]);
  gsmbp_check ("feedforward: where the loops do not close the inputs stay", ...
               r.samples.v(:,[4, 1]) - c.u0', 0);
end

function x = closed (m)
  x = [gsmbp_assemble(m, m.initial(1:4))(1:4); zeros(m.sizes.nx - 4, 1)];
end

## at rest springs balance the force: K (qr - q) + J' F = 0
function impedance (m, e)
  c = gsmbp_model_control (m, "impedance", "K", [100; 60], "zeta", 0.7, "period", 1e-3, "trim", e);
  mc = with (m, c);
  qr = e.x([1, 3]);
  r = gsmbp_simulate (mc, e.x, [0, 8], "input", [20; 5; qr; zeros(4, 1)]);
  q = r.x(end,1:4)';
  p = gsmbp_point (m, "hand", 0, q, zeros (4, 1), "independent", {"q1", "q2"});
  gsmbp_check ("impedance: it yields to a force as its springs do [N m]", ...
               [100; 60] .* (qr - q([1, 3])) + p.jacobian(1:2,:)' * [20; 5], 1e-9);
  q = e.x(1:4);
  MR = gsmbp_reduced (m, 0, q, zeros (4, 1), {"q1", "q2"}).M;
  u = closed_speeds (m, q, [0.3; -0.2]);
  D = 2 * 0.7 * sqrt ([100; 60] .* diag (MR));
  r = gsmbp_simulate (mc, [q; u; 0], [0, 1e-3], "input", [0; 0; qr; zeros(4, 1)]);
  gsmbp_check ("impedance: the first inputs, damped by the reduced mass matrix", ...
               r.samples.v(1,[1, 4]) - asked (m, q, u, -D .* u([1, 3]), MR), 1e-11);
end

function u = closed_speeds (m, q, w)
  one = [q, zeros(4, 3)];
  one([1, 3],2) = w;
  u = m.clo (0, one)(:,2);
end

## inputs t2 and voltage for efforts F on the independent speeds beside what balances the machine
function v = asked (m, q, u, F, MR)
  one = [q, u, zeros(4, 2)];
  one([1, 3],3) = MR \ F;
  one = m.clo (0, one);
  tau = m.inl (0, one(:,1), one(:,2), one(:,3), zeros (m.sizes.nv, 1));
  v = [tau(2), 1.2 * tau(1) / (20 * 0.062) + 0.062 * 20 * u(1)];
end

## the hand between springs of 800 and 300 N/m by its own axes
function hand (m, e)
  K = [800, 300, 0];
  c = gsmbp_model_control (m, "cartesian impedance", "K", K, "D", [60, 60, 0], "axes", "tool", ...
                           "period", 1e-3, "trim", e);
  mc = with (m, c);
  r = gsmbp_simulate (mc, e.x, [0, 6], "input", [20; 5; c.r0]);
  p = gsmbp_point (m, "hand", 0, r.x(end,1:4)');
  gsmbp_check ("cartesian impedance: the hand yields by its springs [N]", ...
               p.rotation * diag (K) * p.rotation' * (c.r0(1:3) - p.position) + [20; 5; 0], 1e-9);
  r = gsmbp_simulate (mc, e.x, [0, 0.1]);
  gsmbp_check ("cartesian impedance: at rest nothing moves", r.x - e.x', 1e-11);
  q = e.x(1:4);
  u = closed_speeds (m, q, [0.3; -0.2]);
  shift = [0.02; -0.01; 0; 0; 0; 0.3; 0.1; 0.2; 0; 0; 0; 0];
  r = gsmbp_simulate (mc, [q; u; 0], [0, 1e-3], "input", [0; 0; c.r0 + shift]);
  p = gsmbp_point (m, "hand", 0, q, u, "independent", {"q1", "q2"});
  R = p.rotation;
  F = R * (diag (K) * R' * shift(1:3) ...
           + diag ([60, 60, 0]) * R' * (shift(7:9) - p.jacobian(1:3,:) * u([1, 3])));
  MR = gsmbp_reduced (m, 0, q, zeros (4, 1), {"q1", "q2"}).M;
  gsmbp_check ("cartesian impedance: the first inputs, springs by the tool's axes", ...
               r.samples.v(1,[1, 4]) - asked (m, q, u, p.jacobian(1:3,:)' * F, MR), 1e-10);
end

## in space: tau = h + J' (K e + D e'), turns as rotation vectors, more than a quarter turn away
function tool ()
  m = gsmbp_fixture ("control_wrist");
  K = diag ([500, 400, 300, 20, 15, 10]);
  K(1,5) = K(5,1) = 30;
  D = diag ([20, 20, 20, 1, 2, 3]);
  c = gsmbp_model_control (m, "cartesian impedance", "K", K, "D", D, "period", 1e-3, ...
                           "parameters", struct ("g", 1));
  [mc, moon] = deal (with (m, c), gsmbp_set (m, "g", 1));
  [q, u] = deal ([0.5; -0.4; 0.9], [0.2; -0.3; 0.5]);
  p = gsmbp_point (m, "tool", 0, q, u);
  for w = [0.4, 2, 0; -0.3, -1.1, 0; 1.2, 0.4, 1e-9]
    wd = [0.3; 0.1; -0.2];
    x = norm (w);
    W = [0, -w(3), w(2); w(3), 0, -w(1); -w(2), w(1), 0];
    rate = wd + (1 - cos (x)) / x ^ 2 * W * wd + (x - sin (x)) / x ^ 3 * W * W * wd;
    if (x < 1e-6)
      rate = wd + W * wd / 2;
    end
    turn = real (logm (expm (W) * p.rotation'));
    e = [[0.3; 0.1; 0.2] - p.position; turn(3,2); turn(1,3); turn(2,1)];
    F = K * e + D * ([0.1; 0; -0.1; rate] - p.jacobian * u);
    r = gsmbp_simulate (mc, [q; u], [0, 1e-3], "input", [0.3; 0.1; 0.2; w; 0.1; 0; -0.1; wd]);
    gsmbp_check (sprintf ("tool in space, axes turned by %.2g rad: efforts as believed", x), ...
                 r.samples.v(1,1:3)' - moon.inv (0, q, u, zeros (3, 1), zeros (3, 1)) ...
                 - p.jacobian' * F, 1e-10);
  end
end

function refused (m)
  cart = gsmbp_fixture ("case_d6a");
  arm = gsmbp_fixture ("control_arm");
  wrist = gsmbp_fixture ("control_wrist");
  for row = {{cart, "impedance", "K", 1, "period", 1}, "has no inputs of a motion", ...
             {m, "impedance", "K", 1, "period", 1, "inputs", {"fx", "t2"}}, ...
             "expected those of the drives (t2, D1.v), found fx, t2", ...
             {m, "computed torque", "Kp", [1, 2, 3], "period", 1}, "expected 1 or 2 numbers", ...
             {m, "computed torque", "Kp", 1, "period", 1, "trim", 3}, "result of gsmbp_trim", ...
             {m, "impedance", "K", 1, "period", 1, "measured", {"a1", "a2", "w1", "w3"}}, ...
             "expected names of outputs, found \"w3\"", ...
             {m, "impedance", "Kp", 1, "period", 1}, "impedance has none, expected K, D, zeta", ...
             {arm, "cartesian impedance", "K", 1, "period", 1}, "without PNT and JPT", ...
             {wrist, "cartesian impedance", "K", 1, "period", 1, "frame", "tol"}, ...
             "option frame: expected one of \"tool\", found \"tol\"", ...
             {wrist, "cartesian impedance", "K", [1 2 3 4], "period", 1}, "expected 1, 3 or 6", ...
             {wrist, "cartesian impedance", "K", [1 2 0; 0 1 0; 0 0 1], "period", 1}, ...
             "expected a symmetric matrix", ...
             {wrist, "cartesian impedance", "K", 1, "period", 1, "damping", -1}, "not negative"}
    if (iscell (row{1}))
      args = row{1};
    else
      said = gsmbp_complaint (@() gsmbp_model_control (args{:}));
      gsmbp_check (["refused: " row{1}], ! isempty (strfind (said, row{1})));
    end
  end
end
