## Controllers that calculate with INV and MAS of the scene: the errors of computed torque are those
## of its linear equation, each law gives the efforts of the equations of motion, an arm with
## impedance yields to a force as its springs do; wrong masses, limits; what is refused.

function test_model_control ()
  m = gsmbp_fixture ("control_arm");
  computed_torque (m);
  impedance (m);
  refused (m);
end

function mc = with (c)
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  mc = gsmbp_build ("control_arm", "directory", folder, "controller", c);
end

function computed_torque (m)
  gains = {"Kp", 100, "Kd", 20, "inputs", {"t1", "t2"}};
  c = gsmbp_model_control (m, "computed torque", gains{:}, "period", 2e-4);
  f = gsmbp_model_control (m, "feedforward", "Kp", 50, "Kd", 5, "Ki", 30, "period", 1e-3, ...
                           "inputs", {"t1", "t2"}, "limits", [30; 10], "parameters", ...
                           struct ("m2", 1.5));
  plan = gsmbp_plan ("quintic", [0.5, 0; -0.5, 1], [0, 1]);
  mc = with (c);
  pp = gsmbp_model_control (mc, "references", plan);
  x0 = [0.6; 0.1; 0; 0];
  t = (0:0.1:1)';
  r = gsmbp_simulate (mc, x0, t, "input", pp);
  e = r.x(:,1:2) - ppval (plan, t')';
  gsmbp_check ("computed torque: e'' + 20 e' + 100 e = 0, of the error at the start", ...
               e ./ e(1,:) - (1 + 10 * t) .* exp (-10 * t), 3e-3);
  a = [0; 0] + 100 * ([0.5; -0.5] - x0(1:2));
  gsmbp_check ("computed torque: the first effort is INV [N m]", ...
               r.samples.v(1,1:2)' - m.inv (0, x0(1:2), [0; 0], a, [0; 0; 0]), 1e-12);
  mc = with (f);
  r = gsmbp_simulate (mc, [0.5; -0.5; 0; 0], [t; 4], "input", ...
                      gsmbp_model_control (mc, "references", plan));
  light = gsmbp_set (m, "m2", 1.5);
  gsmbp_check ("feedforward: the first effort is INV of the masses that it believes [N m]", ...
               r.samples.v(1,1:2)' - light.inv (0, [0.5; -0.5], [0; 0], ppval (ppder (ppder ...
               (plan)), 0), [0; 0; 0]), 1e-12);
  gsmbp_check ("feedforward: wrong masses are seen on the way, the integral takes them away", ...
               max (abs (r.x(1:11,1) - ppval (plan, t')(1,:)')) > 1e-3 ...
               && max (abs (r.x(end,1:2) - [0, 1])) < 5e-3);
  gsmbp_check ("feedforward: within its limits", ...
               all (max (abs (r.samples.v(:,1:2))) <= [30, 10]));
end

## at rest springs balance the force at the tip: K (qr - q) + J' [0; F] = 0
function impedance (m)
  c = gsmbp_model_control (m, "impedance", "K", [80; 60], "zeta", 0.7, "period", 1e-3, "inputs", ...
                           {"t1", "t2"});
  mc = with (c);
  qr = [0.4; -0.7];
  r = gsmbp_simulate (mc, [0.5; -0.6; 0.3; 0.2], [0, 8], "input", [20; qr; 0; 0; 0; 0]);
  q = r.x(end,1:2)';
  J = [0.4 * cos(q(1)) + 0.3 * cos(q(1) + q(2)), 0.3 * cos(q(1) + q(2))];
  gsmbp_check ("impedance: it yields to a force as its springs do [N m]", ...
               [80; 60] .* (qr - q) + J' * 20, 1e-9);
  q = [0.5; -0.6];
  D = 2 * 0.7 * sqrt ([80; 60] .* diag (m.mas (0, q)));
  wanted = m.inv (0, q, [0.3; 0.2], [0; 0], [0; 0; 0]) + [80; 60] .* (qr - q) - D .* [0.3; 0.2];
  gsmbp_check ("impedance: the first effort, damped by MAS [N m]", ...
               r.samples.v(1,1:2)' - wanted, 1e-12);
end

function refused (m)
  loop = gsmbp_fixture ("case_d6a");
  for row = {{m, "computed torque", "Kp", 1, "inputs", {"t1", "t2"}}, "period: expected", ...
             {m, "impedance", "K", -1, "period", 1, "inputs", {"t1", "t2"}}, "not negative", ...
             {m, "impedance", "K", 1, "period", 1, "inputs", {"t2", "push"}}, ...
             "expected those of the drives (t1, t2), found t2, push", ...
             {m, "impedance", "K", 1, "period", 1, "inputs", {"t1", "t2"}, "measured", ...
              {"a2", "a1", "w1", "w2"}}, "is q1 in place 1; found a2, which is q2", ...
             {m, "impedance", "K", 1, "period", 1, "zeta", 1, "D", 2}, "zeta or D, found both", ...
             {m, "impedance", "K", 1, "period", 1, "name", "3ctl"}, "begins with a letter", ...
             {loop, "impedance", "K", 1, "period", 1}, "has no inputs of a motion", ...
             {m, "references", gsmbp_plan("quintic", [0 1; 0 1], [0 1])}, "has no inputs that are"}
    if (iscell (row{1}))
      args = row{1};
    else
      said = gsmbp_complaint (@() gsmbp_model_control (args{:}));
      gsmbp_check (["refused: " row{1}], ! isempty (strfind (said, row{1})));
    end
  end
  c = gsmbp_model_control (m, "impedance", "K", 1, "period", 1, "inputs", {"t1", "t2"});
  said = gsmbp_complaint (@() gsmbp_controller (c, tempname (), 3));
  gsmbp_check ("refused: alone, with a number", ! isempty (strfind (said, "argument, found 3")));
  said = gsmbp_complaint (@() gsmbp_controller (c, tempname ()));
  gsmbp_check ("refused: alone, without the scene", ...
               ! isempty (strfind (said, "calculates with subroutines of control_arm")));
end
