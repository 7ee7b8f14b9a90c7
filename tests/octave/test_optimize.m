## gsmbp_optimize: known optima, multipliers, contradictions, limits, refusals.

function test_optimize ()
  if (! gsmbp_has_nlopt () || ! gsmbp_has_ipopt ())
    printf ("ok left out: libnlopt-dev or coinor-libipopt-dev is not installed\n");
    return;
  end
  lamp (gsmbp_fixture ("design_lamp"));
  chosen (gsmbp_fixture ("design_lamp"));
  cases (gsmbp_fixture ("design_lamp"));
  contradicting (gsmbp_fixture ("design_lamp"));
  refused (gsmbp_fixture ("design_lamp"));
  press (gsmbp_fixture ("design_press"));
  gear (gsmbp_fixture ("design_drive"));
  four_bar (gsmbp_fixture ("design_fourbar"));
end

function near (what, found, expected, tolerance)
  off = max (abs (found - expected) ./ abs (expected));
  gsmbp_check (sprintf ("%s, found %.2g off", what, off), off < tolerance);
end

## static balance: a spring, a counterweight (k*h*r = m*g*l; mc*lc = m*l); a damper for a run, held
## against a search without derivatives
function lamp (m)
  still = {"positions", "q", linspace(-1.2, 1.3, 7)'};
  k = (2 * 0.4 - 0.1) * 9.81 / (0.3 * 0.2);
  for goal = {"square", "peak"}
    r = gsmbp_optimize (m, {"k", 50, [1 1000]}, {goal{1}, "effort.q"}, {}, still);
    near (["a spring balances the arm, by " goal{1}], r.values.k, k, 1e-6);
    gsmbp_check ("with exact derivatives, solved", strcmp (r.derivatives, "exact") && r.solved);
  end
  free = {"mc", 1, [0.1 10]; "lc", 0.1, [0.01 0.4]};
  r = gsmbp_optimize (gsmbp_set (m, "k", 0), free, {"end", "total"}, {"each", "effort.q", "=", ...
                                                                      0}, ...
                      still);
  near ("the lightest counterweight", [r.values.mc, r.values.lc], [2, 0.4], 1e-6);
  bound = r.active(strcmp ({r.active.kind}, "bound"));
  near ("its multiplier at the longest arm, mc/lc", bound.multiplier, 5, 1e-5);
  t = linspace (0, 2, 21)';
  [r, info] = gsmbp_optimize (m, {"d", 0.5, [0 20]}, {"square", "q"}, {}, {"run", t, [0.5 0]});
  w = r.results.case1.w';
  f = @(d) w * gsmbp_simulate (gsmbp_set (m, "d", d), [0.5 0], t).x(:,1) .^ 2 / 2;
  d = fminbnd (f, 5, 15, optimset ("TolX", 1e-8));
  near ("the best damper of a run", r.values.d, d, 1e-6);
  gsmbp_check ("solved", info == 0);
  [r, info] = gsmbp_optimize (m, {"d", 0.5, [0 20]}, {"square", "q"}, {"value", "d", "<", 3; ...
                              "end", "q", "<", 1}, {"run", t, [0.5 0]}, "solver", "ipopt");
  gsmbp_check ("a demand that holds it back, with its price", info == 0 ...
               && abs (r.values.d - 3) < 1e-6 && strcmp ({r.active.text}, "value d < 3") ...
               && abs (r.active.multiplier + (f(3.001) - f(2.999)) / 0.002) < 1e-5);
end

## from a list, several starts that find the same end, one's own variable in a gain
function chosen (m)
  still = {"positions", "q", [-1; 0; 1]};
  r = gsmbp_optimize (m, {"mc", 1, {0.5, 2, 8}; "k", 50, [1 1000]}, {"value", "k"}, ...
                      {"peak", "effort.q", "<", 1e-3}, still, "starts", 2, "seed", 3);
  near ("of a list the one with the softest spring", [r.values.mc, r.values.k], ...
        [2, (0.8 - 0.2) * 9.81 / 0.06], 1e-3);
  gsmbp_check ("all ends are told", numel (r.starts) == 6 && ! isempty (strfind (r.report, ...
               "best of 6 ends (2 starts, 3 combinations)")));
  t = linspace (0, 1, 21)';
  m = gsmbp_set (m, "k", (2 * 0.4 - 0.1) * 9.81 / 0.06);
  follow = {"run", t, [0.2 0], "gain", @(p) [p.kp, 2], "reference", [0 0]};
  [r, info] = gsmbp_optimize (m, {"kp", 5, [0 50]}, {"value", "kp"}, {"end", "q", "<", 0.05}, ...
                              follow);
  late = gsmbp_simulate (m, [0.2 0], t, "gain", [r.values.kp 2], "reference", [0 0]).x(end,1);
  gsmbp_check ("a gain, by differences, and it is said", info == 0 && abs (late - 0.05) < 1e-7 ...
               && ! isempty (strfind (r.derivatives, "differences of order 4 by kp")));
end

## two load cases at once, a peak of runs, a frequency, a settling time, a tracking error
function cases (m)
  t = linspace (0, 1, 21)';
  two = {{"run", t, [0.3 0], "input", 0, "name", "a"}, {"run", t, [-0.3 0], "input", 0, "name", ...
                                                        "b"}};
  [r, info] = gsmbp_optimize (m, {"d", 2, [0.1 20]}, {"peak", "q_d"}, {"end", "total", "<", 9}, ...
                              two);
  most = @(d) max ([abs(gsmbp_simulate (gsmbp_set (m, "d", d), [0.3 0], t, "input", 0).x(:,2)); ...
                    abs(gsmbp_simulate (gsmbp_set (m, "d", d), [-0.3 0], t, "input", 0).x(:,2))]);
  gsmbp_check ("the largest speed of two runs is as small as it can be, at a bound", info == 0 ...
               && abs (r.values.d - 20) < 1e-6 && abs (r.J - most (20)) < 1e-8);
  m = gsmbp_set (m, "mc", 8);
  [r, info] = gsmbp_optimize (m, {"k", 50, [1 1000]; "lc", 0.1, [0.1 0.1001]}, {"value", "k"}, ...
                              {"end", "frequency1", ">", 4}, {"rest", [0; 0], 0});
  e = gsmbp_trim (r.model, [0; 0], 0);
  w = abs (eig (r.model.jac (0, e.x, 0)));
  near ("the softest spring for a frequency at rest", max (w), 4, 1e-6);
  [r, info] = gsmbp_optimize (gsmbp_fixture ("design_rotor"), {"k", 20, [1 1000]}, ...
                              {"value", "k"}, {"end", "frequency1", ">", 30}, ...
                              {"rest", zeros(6, 1), [], "hold", "s"});
  near ("the same where the pole is a double one, k = Jd*w^2", r.values.k, 0.05 * 900, 1e-7);
  gsmbp_check (["... by " r.derivatives], info == 0 ...
               && strcmp (r.derivatives, "differences of order 4 by k"));
  m = gsmbp_set (m, "mc", 2, "lc", 0.4, "k", 0.001, "d", 1);
  follow = {"run", t, [0.2 0], "gain", @(p) [p.kp, 2], "reference", [0 0], "target", ...
            struct("q", 0), "band", 0.1};
  [r, info] = gsmbp_optimize (m, {"kp", 9, [1 50]}, {"value", "kp"}, ...
                              {"settling", "error.q", "<", 0.6; "rms", "error.q", "<", 1}, follow);
  x = gsmbp_simulate (m, [0.2 0], [0 0.6], "gain", [r.values.kp 2], "reference", [0 0]).x(2,1);
  gsmbp_check (sprintf ("the softest gain that has settled in 0.6 s, %.5f of 0.02", x), ...
               info == 0 && abs (x - 0.02) < 2e-4);
end

function contradicting (m)
  still = {"positions", "q", [-1; 0; 1]};
  m = gsmbp_set (m, "k", 0);
  free = {"mc", 1, [0.1 10]; "lc", 0.1, [0.01 0.4]};
  demands = {"value", "lc", "<", 0.39; "peak", "effort.q", "<", 1; "end", "total", "<", 3.5
             "value", "mc", ">", 0.2};
  [r, info] = gsmbp_optimize (m, free, {"end", "total"}, demands, still);
  gsmbp_check ("a least set of demands that contradict each other", info == 2 ...
               && isequal (sort (r.conflict), sort ({"peak effort.q < 1", "end total < 3.5"})));
  text = gsmbp_complaint (@() gsmbp_optimize (m, free, {"end", "total"}, demands, still));
  gsmbp_check ("an error where nobody asks", ! isempty (strfind (text, "contradict each other")));
  demands = {"peak", "effort.q", "<", -1};
  [~, info] = gsmbp_optimize (m, free, {}, demands, still);
  gsmbp_check ("one that cannot be met alone", info == 2);
  [~, info] = gsmbp_optimize (m, {"k", 40, [1 500]}, {"value", "k"}, ...
                              {@(p) 0.67 - sqrt (p.k - 1), ">", 1});
  gsmbp_check ("one that is missed where its derivative is infinite", info == 2);
  r = gsmbp_optimize (m, {"k", 1, [1e-9 1e9]}, {"value", "k"}, {"value", "k", ">", 3e8});
  gsmbp_check (sprintf ("solved is an optimum far from the start, or not said: %g", r.values.k), ...
               ! r.solved || abs (r.values.k / 3e8 - 1) < 1e-6);
  for top = [10 1e3 1e6]
    [r, info] = gsmbp_optimize (m, {"k", top / 2, [0 top]}, {"value", "k"}, {"value", "k", "=", 1});
    gsmbp_check (sprintf ("an equation between 0 and %g, found %.2g off", top, r.values.k - 1), ...
                 info == 0 && abs (r.values.k - 1) < 2e-9 ...
                 && strcmp (r.active(1).text, "value k = 1") && r.active(1).bound == 1);
  end
  [r, info] = gsmbp_optimize (m, {"k", 40, [1 500]}, {}, {@(p) 5 / p.k, "<", 0.05});
  gsmbp_check (sprintf ("one that a first solver does not meet, by k = %g", r.values.k), ...
               info == 0 && r.values.k >= 100);
end

function refused (m)
  still = {"positions", "q", [-1; 0; 1]};
  go = @(varargin) gsmbp_optimize (m, varargin{:});
  goal = {"peak", "effort.q"};
  cases = {{{"k", 50}, goal, {}, still}, "expected a cell array with a row {name, start"; ...
           {{"k", 50, [1 2]}, goal, {}, still}, "expected a start from 1 to 2, found 50"; ...
           {{"k", 50, [2 1]}, goal, {}, still}, "expected bounds [low, high]"; ...
           {{"k", 5, [1 9]; "k", 5, [1 9]}, goal, {}, still}, "k is given twice"; ...
           {{"kk", 50, [1 99]}, goal, {}, still}, "nothing depends on kk"; ...
           {{"d", 2, [0.1 20]}, {"settling", "q"}, {}, {"run", [0 1 2], [0 1]}}, ...
            "settling q: its band is a share of the first value"; ...
           {{"kk", 50, [1 99]}, {"square", "q_d"}, {}, {"inverse", ...
            gsmbp_plan("quintic", [0 1], [0 1]), [0.1 0.7], "input", 1}}, ...
           "nothing depends on kk"; ...
           {{"k", 50, [1 99]}, {@(p) "a"}, {}, {}}, "expected real numbers, found \"a\""; ...
           {{"k", 50, [1 99]}, {@(p) NaN}, {}, {}}, "expected finite numbers, found NaN"; ...
           {{"k", 50, [1 99]}, {"peek", "q"}, {}, still}, "unknown word \"peek\""; ...
           {{"k", 50, [1 99]}, {"peak", "effort.w"}, {}, still}, ...
               "unknown quantity \"effort.w\""; ...
           {{"k", 50, [1 99]}, goal, {"peak", "q", "<=", 3}, still}, ...
               "relation: expected one of"; ...
           {{"k", 50, [1 99]}, goal, {}, {"ran", 1, 2}}, "unknown kind \"ran\""; ...
           {{"k", 50, [1 99]}, goal, {}, {}}, "needs a load case"; ...
           {{"k", 50, [1 99]}, goal, {"value", "k", "=", 9}, still, "solver", "mma"}, ...
           "mma takes no equations"; ...
           {{"k", 50, [1 99]}, {"peak", "error.q"}, {}, still}, "option \"target\""; ...
           {{"k", 50, [1 Inf]}, goal, {}, still, "starts", 3}, "expected finite bounds of k"};
  for one = cases'
    text = gsmbp_complaint (@() go (one{1}{:}));
    gsmbp_check (["refused: " one{2}], ! isempty (strfind (text, one{2})));
  end
  free = {"k", 50, [1 1000]; "mc", 1, [-5 5]};
  r = gsmbp_optimize (m, free, {"square", "effort.q"}, {}, still, "starts", 4);
  gsmbp_check ("starts where nothing can be calculated are told, the others count", r.solved ...
               && any (strncmp ({r.starts.ended}, ...
                             "no start: gsmbp_optimize: case case1: gsmbp_set: ", 49)));
  [r, info] = gsmbp_optimize (m, {"k", 50, [1 1000]}, {"peak", "effort.q"}, {}, still, ...
                              "evaluations", 3, "solver", "slsqp");
  gsmbp_check ("a limit says so", info == 1 && r.limit ...
               && ! isempty (strfind (r.ended, "stopped at the limit of 3 evaluations")));
end

## the valve that is opened so far that the stroke's margin is kept
function press (m)
  t = (0:0.01:0.2)';
  run = {"run", t, m.initial, "input", @(p) p.u};
  [r, info] = gsmbp_optimize (m, {"u", 1e-4, [0 1e-3]}, {"end", "q", -1}, ...
                              {"min", "state_margin6", ">", 0.3}, run);
  x = gsmbp_simulate (m, m.initial, t, "input", r.values.u).x;
  near ("a margin over a run", max (x(:,1)), 0.4, 1e-6);
  gsmbp_check ("solved", info == 0);
  text = gsmbp_complaint (@() gsmbp_optimize (m, {"u", 1e-4, [0 1e-3]}, ...
                                              {"end", "state_margin9"}, {}, run));
  gsmbp_check ("refused: a margin that is none", ! isempty (strfind (text, ...
               "expected the number of a margin (m.state_margins), 1 to 6")));
end

## D2a: the ratio of least copper loss, and with a motion that is free as well
function gear (m)
  d2a = gsmbp_set (m, "bl", 0, "bm", 0, "tl", 0);
  best = gsmbp_plan ("profile", mkpp ([0 0.8], 6 * 1.2 / 0.8 ^ 2 * [-1/0.8, 1, 0]), 1);
  t = linspace (0, 0.8, 9);
  loss = @(p, r) 1.6 / (0.19 * p.n) ^ 2 * (r.case1.w' * r.case1.tau .^ 2);
  r = gsmbp_optimize (d2a, {"n", 60, [5 300]}, {loss}, {}, {"inverse", best, t});
  near ("D2a: ratio and energy", [r.values.n, r.J], ...
        [94.868329805051379960, 2.1540166204986149584], 1e-6);
  loaded = @(p, r) 1.6 / (0.19 * p.n) ^ 2 * (r.case1.w' * (r.case1.tau + 25) .^ 2);
  r = gsmbp_optimize (d2a, {"n", 90, [5 300]}, {loaded}, {}, {"inverse", best, t});
  near ("D2a, with a load torque", [r.values.n, r.J], ...
        [145.758289033132936499777, 3.61940355984660686649], 1e-6);
  ## theta = cubic with two free coefficients; exact through the equations of motion
  plan = @(p) mkpp ([0 0.8], [p.a, p.b, 0, 0]);
  r = gsmbp_optimize (gsmbp_set (d2a, "n", 90), {"a", -1, [-99 99]; "b", 2, [-99 99]}, ...
                      {"integral", "effort.q*effort.q"}, {"end", "q", "=", 1.2; ...
                      "end", "q_d", "=", 0}, {"inverse", plan, t});
  near ("the motion of least effort: 3 s^2 - 2 s^3", [r.values.a, r.values.b], ...
        1.2 * [-2 / 0.8 ^ 3, 3 / 0.8 ^ 2], 1e-6);
  gsmbp_check ("with exact derivatives", strcmp (r.derivatives, "exact"));
end

## ten unknowns of a four-bar from twelve places of its coupler point
function four_bar (m)
  turns = (0:11)' * pi / 6;
  names = {"xa", "ya", "a", "b", "c", "dx", "dy", "cx", "cy", "th"};
  made = [cellfun(@(n) m.par.(n), names(1:9)), 0.4];
  path = gsmbp_optimize (m, {"th", 0.4, {0.4}}, {}, {}, {"positions", "q1", ...
                                                         @(p) turns + p.th}).results;
  target = struct ("px", path.case1.y(:,1), "py", path.case1.y(:,2));
  start = made + [0.02 -0.02 0.01 0.02 -0.02 0.015 -0.02 0.01 -0.015 0.1];
  free = [names', num2cell(start'), repmat({[-2 2]}, 10, 1)];
  r = gsmbp_optimize (m, free, {"square", "error.px"; "square", "error.py"}, {}, ...
                      {"positions", "q1", @(p) turns + p.th, "target", target});
  off = cellfun (@(n) r.values.(n), names) - made;
  gsmbp_check (sprintf ("a four-bar by its timed path, within 1e-7, found %.2g", ...
                        max (abs (off))), max (abs (off)) < 1e-7);
end
