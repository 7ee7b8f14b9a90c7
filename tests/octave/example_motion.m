## [m, x0, t, options, what] = example_motion (NAME, BUILD): the main run of an example's driver
## (examples/*/run.m), for each scene NAME of the examples: model, start, times, options of
## gsmbp_simulate, one of which tells a usual energy ("audit" [J]), and the motion in words. BUILD
## (name) gives a model.

function [m, x0, t, options, what] = example_motion (name, build)
  m = build (name);
  options = {};
  switch (name)
    case "andrews"
      m.nominal(8:14) = 1000;   # the driver's absolute tolerance: speeds reach 1425 rad/s
      [x0, t, joules, what] = deal (gsmbp_assemble (m, m.initial, "hold", "beta"), 0:0.001:0.03, ...
                                    1, "0.03 s of the benchmark");
    case {"bending_rod", "bending_rod_linear"}
      x0 = gsmbp_assemble (m, [0; 0; 0.45; 0; 0; 100; -150; 0; 0; 0], "hold", "theta");
      [t, options, joules, what] = deal (linspace (0, 0.12, 41), {"start", "project"}, 10, ...
                                         "two turns at 100 rad/s");
    case "balanced_linkage"
      options = {"motion", gsmbp_plan("quintic", [0.6 2.6], [0 1])};
      [x0, t, joules, what] = deal ([], 0:0.1:1, 10, "the swing by computed torque");
    case "bricard"
      [x0, t, joules, what] = deal (m.initial, 0:0.25:10, 10, "falls for 10 s");
    case "flexible_arm"
      [x0, t, options, joules, what] = deal (m.initial, 0:0.01:0.5, {"input", 6}, 1, ...
          "a step of 6 V");
    case "four_bar"
      options = {"motion", mkpp([0, 10], [2*pi, 0])};
      [x0, t, joules, what] = deal ([], 0:0.25:10, 1, "ten turns by computed torque");
    case "hooke"
      [x0, t, options, joules, what] = deal (m.initial, 0:0.05:1.5, {"input", 16}, 10, ...
          "run-up on 16 V");
    case "hooke_double"
      ## with equal bends the ends turn evenly: hardly any energy passes
      m = gsmbp_set (m, "b2", 15 * pi / 180);
      [x0, t, joules, what] = deal (gsmbp_assemble (m, [0 0 0 0 20 0 0 0], "hold", "theta"), ...
                                    linspace (0, pi / 10, 9), 1, ...
                                    "a turn at 20 rad/s, bends 30, 15");
    case {"hydraulic_crane", "hydraulic_crane_pl"}
      options = {"motion", at_rest([0.2 0.8 0.8 0.2; -1 -1.2 -0.6 -1], [0 4 7 12])};
      [x0, t, joules, what] = deal ([], 0:0.5:12, 1e4, "the cycle by the valves' commands");
      if (strcmp (name, "hydraulic_crane"))
        x0 = gsmbp_inverse (m, options{2}, 0, "internal", [5e6; 6e6; 0; 0; 5e6; 6e6; 0; 0]).x';
      end
    case "lead_screw"
      options = {"motion", gsmbp_plan("septic", [0, 200 * pi], [0, 2.5])};
      [x0, t, joules, what] = deal ([], 0:0.1:2.5, 100, "100 turns by computed voltage");
    case "pneumatic_axis"
      options = {"motion", slide()};
      [x0, t, joules, what] = deal ([], 0:0.1:1.8, 1, "forth and back by the valves' commands");
    case "pneumatic_position"
      at = gsmbp_inverse (build ("pneumatic_axis"), slide (), 0);
      ticks = (0:1800)' / 1000;
      place = gsmbp_plan ("table", ticks, gsmbp_evaluate (slide (), ticks)', 3);
      coefs = zeros (3, 1800, 4);
      coefs(1,:,:) = place.coefs;
      coefs(2:3,:,4) = at.v' .* ones (1, 1800);
      [x0, t, options, joules, what] = deal (at.x', 0:0.1:1.8, {"input", mkpp(ticks, coefs, 3)}, ...
          1, "forth and back under the digital PID, 1 kHz");
    case "puma560"
      options = {"motion", gsmbp_plan("quintic", [0.5, 0; -0.75, 0; 0.5, 0], [0, 1])};
      [x0, t, joules, what] = deal ([], 0:0.1:1, 100, "the quintic by computed voltages");
    case "puma560_design"
      [x0, t, options, joules, what] = deal (m.initial, 0:0.05:0.5, {"input", [2; -3; 1]}, 10, ...
          "steps of the voltages");
    case {"robot_joint", "robot_joint_continuous", "robot_joint_sampled"}
      [x0, t, options, what] = joint_run (m, name, build);
      joules = 50;
    case "rolling_disc"
      [lean, axis] = deal (0.5, [0; cos(0.5); sin(0.5)]);
      [centre, w] = deal (m.par.r * [0; -sin(lean); cos(lean)], [0; 0; 1] + 8 * axis);
      R = [1, 0, 0; 0, cos(lean), -sin(lean); 0, sin(lean), cos(lean)];
      x0 = [centre; cos(lean / 2); sin(lean / 2); 0; 0; cross(w, centre); R' * w];
      [t, joules, what] = deal (0:0.5:60, 1, "60 s, leaning by 0.5 rad at 8 rad/s");
    case "rolling_disc_angles"
      x0 = gsmbp_assemble (m, ...
                           [0; -m.par.r * sin(0.5); m.par.r * cos(0.5); 0; 0.5; 0; 0; 0; 0; 1; ...
                            0; 8], "hold", {"heading", "lean", "roll"});
      [t, joules, what] = deal (0:0.5:60, 1, "60 s, leaning by 0.5 rad at 8 rad/s");
    case "rotating_blade"
      [x0, t, joules, what] = deal ([0; 0.3; 0; 0; 0.2; 0; 0; 4; zeros(6, 1)], 0:0.1:5, 100, ...
                                    "5 s, bent both ways on a free hub");
    case {"rotating_blade_spin_up", "rotating_blade_linear"}
      [x0, t, joules, what] = deal (m.initial, 0:0.1:5, 100, "5 s of the spin-up");
    case "scara"
      [~, q] = scara_gate (m, 2);
      options = {"motion", scara_cycle(q)};
      [x0, t, joules, what] = deal ([], 0:0.05:1.25, 10, "from pick to place by double S");
    case "slider_crank"
      options = {"motion", gsmbp_plan("profile", mkpp ([0 1 2 6], [4 0; -4 4; 0 0]), 2)};
      [x0, t, joules, what] = deal ([], 0:0.25:6, 10, "the profile by computed voltage");
    case "slider_crank_design"
      x0 = gsmbp_assemble (m, m.initial, "hold", "q1");
      [t, options, joules, what] = deal (0:0.05:1, {"input", 6}, 1, "a step of 6 V");
    case "slider_crank_induction"
      [x0, t, options, joules, what] = deal (m.initial, 0:0.05:1.5, ...
          {"input", [220 * sqrt(2/3); 0; 377]}, 1000, "start on the mains");
    case "spinning_top"
      [x0, t, joules, what] = deal ([cos(pi/12); sin(pi/12); 0; 0; 0; 0; 250], 0:0.1:10, 1, ...
                                    "10 s, released without precession");
    case "spinning_top_angles"
      [x0, t, joules, what] = deal ([0; pi/6; 0; 0; 0; 250], 0:0.1:10, 1, ...
                                    "10 s, released without precession");
    case "stewart"
      [t, x, force] = stewart_plan (m);
      [x0, options, joules, what] = deal (x(1,:)', {"input", gsmbp_plan("table", t, force, 3)}, ...
          10, "6 s by computed force, a table of 5 ms");
      t = 0:0.25:6;
    case {"two_link_arm", "two_link_rigid"}
      [x0, t, options, joules, what] = deal (m.initial, 0:0.01:0.5, {"input", [5; -2]}, 1, ...
          "steps of both torques");
    case "welding_arm"
      p = welding_plan (m, 0.35);
      options = {"motion", p.motion};
      [x0, t, joules, what] = deal ([], 0:0.25:6.25, 100, "both seams by computed voltages");
    otherwise
      error ("example_motion: %s has no line here", name);
  end
  if (isempty (x0))
    x0 = gsmbp_inverse (m, options{2}, 0).x';
  end
  options = [options, {"audit", joules}];
end

## from rest to rest at the columns of Q, five derivatives zero there
function motion = at_rest (q, times)
  coefs = zeros (rows (q), columns (q) - 1, 12);
  for k = 1:columns (q) - 1
    coefs(:,k,1:6) = reshape (diff (q(:,k:k+1), 1, 2) ...
                                * ([-252 1386 -3080 3465 -1980 ...
                                      462] ./ diff (times(k:k+1)) .^ (11:-1:6)), rows (q), 1, ...
                              6);
    coefs(:,k,12) = q(:,k);
  end
  motion = mkpp (times, coefs, rows (q));
end

function plan = slide ()
  plan = gsmbp_plan ("septic", [0.02 0.06 0.06 0.02 0.02], [0 0.4 0.8 1.2 1.8]);
end

## the joint by its voltage, or under its cascade: 1.2 rad in 1 s from rest, the arm held by the
## controller's integral part
function [x0, t, options, what] = joint_run (m, name, build)
  free = build ("robot_joint");
  plan = gsmbp_plan ("septic", [0 1.2 1.2], [0 1 1.5]);
  begin = fzero (@(theta) gsmbp_inverse (free, plan, 0, "internal", [theta; 0; 0]).x(4), [0 1]);
  x0 = gsmbp_inverse (free, plan, 0, "internal", [begin; 0; 0]).x';
  c = reshape (plan.coefs, 1, plan.pieces, plan.order);
  rate = cat (3, zeros (1, plan.pieces), c(:,:,1:end-1) .* reshape (plan.order-1:-1:1, 1, 1, []));
  reference = mkpp (plan.breaks, [100 * [c; rate]; zeros(1, plan.pieces, plan.order)], 3);
  held = x0(5) * 0.318;
  t = 0:0.1:1.5;
  switch (name)
    case "robot_joint"
      [options, t, what] = deal ({"motion", gsmbp_plan("septic", [0 1.2], [0 1])}, 0:0.1:1, ...
                                 "1.2 rad by computed voltage");
    case "robot_joint_continuous"
      [x0, options, what] = deal ([x0; begin; held / m.par.ks; held], {"input", reference}, ...
                                  "1.2 rad under the cascade");
    case "robot_joint_sampled"
      [options, what] = deal ({"input", reference, "memory", [begin; 1; held / m.par.ks]}, ...
                              "1.2 rad under the digital cascade, 1 kHz");
  end
end
