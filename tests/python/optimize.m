## optimize (FILE): designs by gsmbp_optimize, written as JSON, for optimize.py.

function optimize (file)
  warning ("off", "all");
  m = gsmbp_fixture ("design_lamp");
  t = linspace (0, 2, 21)';
  run = {"run", t, [0.5 0]};
  r.damper = told (m, {"d", 0.5, [0 20]}, {"square", "q"}, {}, run);
  r.held = told (m, {"d", 0.5, [0 20]}, {"square", "q"}, {"value", "d", "<", 3; ...
                 "end", "q", "<", 1}, run, "solver", "ipopt");
  r.two = told (m, {"d", 2, [0.1 20]}, {"peak", "q_d"}, {"end", "total", "<", 9}, ...
                {{"run", t, [0.3 0], "input", 0, "name", "a"}, ...
                 {"run", t, [-0.3 0], "input", 0, "name", "b"}});
  path = struct ("q", @(t) -pi / 2 + 0.3 * exp (-2 * t));
  words = {"start", "end", "mean", "integral", "drawn", "square", "rms", "peak", "max", "min", ...
           "settling"};
  for word = words
    r.(["word_" word{1}]) = told (m, {"d", 2, [0.1 20]}, {word{1}, "error.q*q"}, ...
                                  {"value", "d", "=", 2}, [run, {"target", path, "band", 0.5}]);
  end
  lamp = gsmbp_set (m, "mc", 8);
  r.rest = told (lamp, {"k", 50, [1 1000]}, {"value", "k"}, {"end", "frequency1", ">", 4; ...
                 "end", "decay", ">", 0}, {"rest", [0; 0], 0});
  r.double_pole = told (gsmbp_fixture ("design_rotor"), {"k", 20, [1 1000]}, {"value", "k"}, ...
                        {"end", "frequency1", ">", 30}, {"rest", zeros(6, 1), [], "hold", "s"});
  lamp = gsmbp_set (m, "k", 0);
  free = {"mc", 1, num2cell(0.3 + 0.13 * (0:49)); "lc", 0.1, num2cell(0.05 + 0.0137 * (0:39))};
  r.branch = told (lamp, free, {"mass", "weight", 1; "value", "lc", 8}, ...
                   {"peak", "effort.q", "<", 0.5}, {"positions", "q", 0});
  free = {"mc", 1, [0.1 10]; "lc", 0.1, [0.01 0.4]};
  r.conflict = told (lamp, free, {"end", "total"}, {"value", "lc", "<", 0.39; ...
                     "peak", "effort.q", "<", 1; "end", "total", "<", 3.5; ...
                     "value", "mc", ">", 0.2}, {"positions", "q", [-1; 0; 1]});
  m = gsmbp_fixture ("sensitivity_crank");
  t = linspace (0, 0.2, 41)';
  r.loops = told (m, {"n", 20, [2 80]}, {"rms", "motor.i"}, {"end", "q1", ">", 0.8, "one"}, ...
                  {{"run", t, m.initial, "input", 12, "name", "one"}, ...
                   {"run", t, m.initial, "input", -9, "name", "two"}});
  plan = gsmbp_plan ("septic", [0.3 2.6], [0 1.5]);
  r.slider = told (gsmbp_set (m, "g", -9.81), {"m3", 2, [0 50]}, {"square", "motor.i"}, {}, ...
                   {"inverse", plan, linspace(0, 1.5, 41)});
  words = {"hold", "q1", "free", "motor.v"};
  e = gsmbp_trim (m, gsmbp_assemble (m, [0.3; -0.1; 0.7], "hold", "q1"), 0, words{:});
  lamp = gsmbp_fixture ("design_lamp");
  sensitivity = struct ("design_lamp", equilibrium (lamp, gsmbp_trim (lamp, [0; 0], 0), {}), ...
                        "sensitivity_crank", equilibrium (m, e, words));
  fid = fopen (file, "w");
  fputs (fid, jsonencode (struct ("designs", r, "sensitivity", sensitivity)));
  fclose (fid);
end

function one = told (m, varargin)
  [r, info] = gsmbp_optimize (m, varargin{:});
  one = struct ("values", r.values, "J", r.J, "info", info, "ended", r.ended, "solver", ...
                r.solver, "derivatives", r.derivatives, "report", r.report, "evaluations", ...
                r.evaluations, "texts", {{r.active.text}}, "multipliers", ...
                {num2cell([r.active.multiplier])}, "conflict", {r.conflict}, ...
                "problems", r.choices.solved);
end

function r = equilibrium (m, e, words)
  s = gsmbp_sensitivity (m, e.x, e.v, words{:});
  r = struct ("x", e.x', "v", e.v', "options", {words}, "names", {s.names}, ...
              "poles", pairs (s.poles), "frequency", s.frequency', "damping", s.damping');
  for part = {"dx", "dv", "dy", "dpoles", "dfrequency", "ddamping"}
    r.(part{1}) = cellfun (@(name) pairs (s.(part{1}).(name)), s.names, "UniformOutput", false);
  end
end

function p = pairs (z)
  p = struct ("re", real (z(:))', "im", imag (z(:))');
end
