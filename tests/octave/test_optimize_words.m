## gsmbp_optimize: the words of goals and demands, each against what is known of it otherwise.

function test_optimize_words ()
  if (! gsmbp_has_nlopt () || ! gsmbp_has_ipopt ())
    printf ("ok left out: libnlopt-dev or coinor-libipopt-dev is not installed\n");
    return;
  end
  currents (gsmbp_fixture ("sensitivity_crank"));
  runs (gsmbp_fixture ("design_lamp"));
  gains (gsmbp_fixture ("design_lamp"), gsmbp_fixture ("sensitivity_sampled"));
  if (isempty (pkg ("list", "control")))
    printf ("ok left out: the margins of loops need the package control\n");
    return;
  end
  pkg load control
  margins (gsmbp_fixture ("design_lamp"));
end

function near (what, found, expected, tolerance)
  off = max (abs (found - expected) ./ abs (expected));
  gsmbp_check (sprintf ("%s, found %.2g off", what, off), off < tolerance);
end

## rms current, energy drawn and peak torque of two runs of a slider-crank with a motor at once
function currents (m)
  t = linspace (0, 0.2, 41)';
  x = gsmbp_assemble (m, m.initial, "hold", "q1");
  one = {"run", t, x, "input", 12, "name", "one"};
  two = {"run", t, x, "input", -9, "name", "two"};
  r = gsmbp_optimize (m, {"n", 20, [2 80]}, {"rms", "motor.i"}, {"end", "q1", ">", 0.8, "one"}, ...
                      {one, two});
  f = @(n, v) gsmbp_simulate (gsmbp_set (m, "n", n), x, t, "input", v);
  gsmbp_check ("solved, exact", r.solved && strcmp (r.derivatives, "exact"));
  w = r.results.one.w(:)';
  rms = @(r) sqrt (w * r.of.("motor.i") .^ 2 / 0.2);
  near ("the goal is the sum of both rms currents", r.J, ...
        rms (f(r.values.n, 12)) + rms (f(r.values.n, -9)), 1e-7);
  d = 1e-3;
  J = @(n) rms (f(n, 12)) + rms (f(n, -9));
  slack = f(r.values.n, 12).x(end,1) - 0.8;
  gsmbp_check ("it is held back by the way, or flat", abs (slack) < 1e-6 ...
               || abs (J(r.values.n + d) - J(r.values.n - d)) < 1e-4);
  r = gsmbp_optimize (m, {"n", 20, [2 80]}, {"drawn", "motor.v*motor.i"}, ...
                      {"end", "q1", "=", 0.8}, one);
  at = fzero (@(n) f(n, 12).x(end,1) - 0.8, r.values.n + [-1, 1]);
  near ("the ratio that comes so far, and its energy", [r.values.n, r.J], ...
        [at, w * max(0, 12 * f(at, 12).of.("motor.i"))], 1e-6);
end

## tracking error and settling time, by damper and spring
function runs (m)
  t = linspace (0, 2, 81)';
  m = gsmbp_set (m, "mc", 0.1, "k", 0);
  path = struct ("q", @(t) -pi / 2 + 0.3 * exp (-2 * t));
  x = [-pi / 2 + 0.3, 0];
  go = {"run", t, x, "input", 0, "target", path};
  r = gsmbp_optimize (m, {"d", 2, [0.1 20]}, {"rms", "error.q"}, {}, go);
  miss = @(d) sqrt (trapz (t, (gsmbp_simulate (gsmbp_set (m, "d", d), x, t, "input", ...
                                               0).x(:,1) - path.q(t)) .^ 2));
  d = fminbnd (miss, 0.5, 8, optimset ("TolX", 1e-9));
  near ("the damper that follows a path best", r.values.d, d, 1e-4);
  down = {"run", t, x, "input", 0, "band", 0.2, "target", struct("q", -pi / 2)};
  [r, info] = gsmbp_optimize (m, {"d", 4, [0.1 20]}, {"settling", "error.q"}, {}, down);
  late = @(d) gsmbp_optimize (gsmbp_set (m, "d", d), {"g", 9.81, {9.81}}, ...
                              {"settling", "error.q"}, {}, down).J;
  J = arrayfun (late, r.values.d + [-0.2, 0.2]);
  gsmbp_check (sprintf ("the damper that settles soonest: %.6g s; beside it %.6g, %.6g", ...
                        r.J, J), ...
               r.J <= min (J));
end

## under feedback that stops at a limit; gains of a digital controller of the scene itself
function gains (m, s)
  t = linspace (0, 1, 21)';
  m = gsmbp_set (m, "k", 80);
  law = {"gain", [20 2], "reference", [0.2 0], "limits", 3, "rtol", 1e-12};
  r = gsmbp_optimize (m, {"d", 2, [0.1 20]}, {"rms", "error.q"}, {}, ...
                      [{"run", t, [0.5 0], "target", struct("q", 0.2)}, law]);
  w = r.results.case1.w(:)';
  f = @(d) w * (gsmbp_simulate (gsmbp_set (m, "d", d), [0.5 0], t, law{:}).x(:,1) - 0.2) .^ 2;
  near ("a damper under feedback", r.values.d, fminbnd (f, 3, 6, optimset ("TolX", 1e-10)), 1e-6);
  gsmbp_check ("exact through the feedback", strcmp (r.derivatives, "exact"));
  r = gsmbp_optimize (s, {"kp", 80, [10 150]}, {"rms", "error.q_d"}, {}, ...
                      {"run", 2 * t, [0 0], "input", [1; 0], "target", struct("q_d", 1)});
  f = @(kp) w * (gsmbp_simulate (gsmbp_set (s, "kp", kp), [0 0], 2 * t, "input", ...
                                 [1; 0]).x(:,2) - 1) .^ 2;
  known = fminbnd (f, 10, 150, optimset ("TolX", 1e-10));
  near ("the gain of a digital controller of the scene", r.values.kp, known, 1e-6);
  lastwarn ("");
  gsmbp_optimize (m, {"k", 50, [1 1000]; "mc", 1, [0.5 2]}, {"mass", "all"});
  gsmbp_check (["told: " lastwarn()], ...
               ! isempty (strfind (lastwarn (), "nothing depends on k, at")));
  text = gsmbp_complaint (@() gsmbp_optimize (m, {"k", 50, [1 1000]}, {"end", "q"}, {}, ...
                                              {"run", [1 0], [0 0], "name", "back"}));
  gsmbp_check (["the case is named: " text], ...
               ! isempty (strfind (text, "gsmbp_optimize: case back: ")));
  gsmbp_check ("exact through its samples", strcmp (r.derivatives, "exact"));
end

## PI with the lag cancelled: L = c/(L s) exp(-L s): phase margin pi/2 - c, gain margin pi/(2 c),
## Ms = 1.6 at c = 0.505684
function margins (m)
  tune = @(p) gsmbp_pid (tf (2, [1.5 1]), [], "pi", "pm", p.pm, "Ti", 1.5, "delay", 0.4);
  free = {"pm", 61, [55 70]};
  loop = {"loop", @(p, m) tune(p)};
  r = gsmbp_optimize (m, free, {"value", "pm"}, {"end", "Ms", "<", 1.6}, loop, "tolerance", 1e-7);
  near ("the least phase margin with Ms below 1.6", r.values.pm * pi / 180, ...
        pi / 2 - 0.505684, 1e-6);
  e = gsmbp_optimize (m, {"pm", 60, {60}}, {"end", "Ms"}, {}, loop).results.case1.extra;
  near ("margins at 60 degrees", [e.phase_margin, e.gain_margin], [pi / 3, 3], 1e-9);
  gsmbp_check (["differences are told: " r.derivatives], strncmp (r.derivatives, "differences", ...
                                                                    11));
  text = gsmbp_complaint (@() gsmbp_optimize (m, {"pm", 60, {60}}, {"end", "Mss"}, {}, loop));
  gsmbp_check (["refused: " text], ! isempty (strfind (text, 'unknown quantity "Mss", did you')));
end
