## Every design that gsmbp_build joins starts without a bump: an arm that a motor holds, with
## integrators and observers at the trim; the first commands are the voltage of the trim to rounding
## and nothing moves, with delay too.  A bump is seen where the trim is another one.

function test_bumpless ()
  pkg load control
  m = gsmbp_fixture ("control_boom");
  e = at_angle (m, -0.4);
  for row = designs (m, e)
    [name, c] = row{:};
    starts (m, e, name, c);
  end
  elsewhere (m, e);
end

function e = at_angle (m, q)
  e = gsmbp_trim (m, [q; 0; 0], [0; 0], "hold", "q", "free", "M.v");
end

function list = designs (m, e)
  common = {"inputs", "M.v", "period", 2e-3, "limits", 12};
  late = [common, {"delay", 3e-3}];
  angle = {"measured", "angle"};
  both = {"measured", {"angle", "speed"}};
  noise = {"W", [1e-4, 1, 1], "V", 1e-6};
  poles = {"poles", [-8+4i, -8-4i, -300]};
  pid = @(word, more) gsmbp_pid (m, e, word, "ms", 1.6, more{:}, common{:}, angle{:});
  laws = cellfun (@(q) gsmbp_control (m, at_angle (m, q), "lqg", angle{:}, noise{:}, "track", ...
                                      "angle", late{:}), {-0.8, -0.4, 0.3}, "UniformOutput", false);
  list = {"LQR", gsmbp_control(m, e, "lqr", common{:})
          "LQG with integral, late", gsmbp_control(m, e, "lqg", angle{:}, noise{:}, "integral", ...
                                                   "angle", late{:})
          "LQG", gsmbp_control(m, e, "lqg", angle{:}, noise{:}, "track", "angle", common{:})
          "poles, full observer, late", gsmbp_control(m, e, "place", poles{:}, "observer", ...
                                                      "full", angle{:}, late{:})
          "poles, reduced observer", gsmbp_control(m, e, "place", poles{:}, "observer", ...
                                                   "reduced", angle{:}, common{:})
          "output feedback", gsmbp_control(m, e, "output", both{:}, common{:})
          "H-infinity", gsmbp_control(m, e, "hinf", "weights", {tf(0.5, [0.2, 1]), 0.01, []}, ...
                                      angle{:}, common{:})
          "PID", pid("pid", {"Ti", 0.4, "Td", 0.05})
          "schedule", gsmbp_schedule(laws, "angle", [-0.8, -0.4, 0.3], "start", 2)
          "computed torque", gsmbp_model_control(m, "computed torque", "Kp", 100, "Kd", 20, ...
                                                 "Ki", 50, late{:}, "trim", e)
          "feedforward", gsmbp_model_control(m, "feedforward", "Kp", 5, "Kd", 1, "Ki", 1, ...
                                             common{:}, "trim", e)
          "impedance, late", gsmbp_model_control(m, "impedance", "K", 40, "zeta", 1, late{:}, ...
                                                 "trim", e)}';
end

function starts (m, e, name, c)
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, 0:0.005:0.1);
  gsmbp_check (["bumpless, " name ": first commands are the trim's [V]"], ...
               r.samples.v(1:5,2) - e.v(2), 1e-13 * abs (e.v(2)));
  gsmbp_check (["bumpless, " name ": nothing moves"], r.x - e.x', 1e-12);
end

## a controller of another place, or without its trim, has a bump
function elsewhere (m, e)
  c = gsmbp_control (m, at_angle (m, 1), "lqr", "inputs", "M.v", "period", 2e-3);
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, [0, 0.1]);
  gsmbp_check ("a controller of another trim has a bump", abs (r.samples.v(1,2) - e.v(2)) > 0.1);
end
