## Derivatives by parameters: subroutines against differences, runs against reference values and
## differences, start values, refusals.

function test_sensitivity ()
  pendulum ();
  m = gsmbp_fixture ("sensitivity_crank");
  subroutines (gsmbp_fixture ("case_d1a"));
  subroutines (m);
  crank (m);
  along_a_motion (m);
  inputs (m);
  planned (m);
  beside_a_plan (gsmbp_fixture ("sensitivity_bristles"));
  start_values (gsmbp_fixture ("case_d1a"));
  refused (m);
  equilibrium (m);
  frequency (gsmbp_fixture ("case_d1a"));
  backwards (gsmbp_fixture ("case_d1a"), [1.2; -0.5], [], 2);
  backwards (m, closed (m), 12, 0.3);
  adjoint_refused (m);
end

## the case D1a: 6 parameters, 28 digits
function pendulum ()
  [~, ref] = gsmbp_case ("D1a_pendulum");
  m = gsmbp_fixture ("case_d1a");
  names = ref.parameters';
  r = gsmbp_simulate (m, [1.2, -0.5], [0 0.5 1 2], "sensitivity", names, "rtol", 1e-12);
  worst = 0;
  for i = 1:3
    expected = cell2mat (cellfun (@(c) str2double (c(:)'), ref.at(i).dxdp(:), ...
                                  "UniformOutput", false))';
    found = cell2mat (cellfun (@(p) r.dx.(p)(i+1,:), names, "UniformOutput", false)(:));
    worst = max (worst, max (max (abs (found - expected), [], 2) ./ max (abs (expected), [], 2)));
  end
  gsmbp_check (sprintf ("D1a: dx/dp within 1e-11 of the reference, found %.2g", worst), ...
               worst < 1e-11);
  at_1e8 = gsmbp_simulate (m, [1.2, -0.5], [0 2], "sensitivity", names, "rtol", 1e-8);
  warning ("on", "gsmbp:stiff", "local");
  for method = {"dp853", "auto"}
    stiff = gsmbp_simulate (gsmbp_set (m, "d", 600), [1.2, 0], [0 2], "sensitivity", names, ...
                            "method", method{1});
    gsmbp_check (["bound by stability, " method{1} ": the state is named"], ...
                 any (strcmp (stiff.stats.stiff.state, m.states)));
  end
  lastwarn ("", "");
  gsmbp_simulate (gsmbp_set (m, "d", 600), [1.2, 0], [0 2]);
  said = lastwarn ();
  gsmbp_check (["without devices: " said], any (strfind (said, ": take method \"radau\"")) ...
               && ! any (strfind (said, "actuator")));
  far = max (cellfun (@(p) max (abs (at_1e8.dx.(p)(2,:) - r.dx.(p)(4,:))) ...
                             / max (abs (r.dx.(p)(4,:))), names));
  gsmbp_check (sprintf ("the error test has the columns: within 100 rtol, found %.2g", far), ...
               far < 1e-6);
  rk4 = gsmbp_simulate (m, [1.2, -0.5], [0 2], "sensitivity", "l", "method", "rk4", "step", 2e-4);
  gsmbp_check ("rk4 carries them too", max (abs (rk4.dx.l(2,:) - r.dx.l(4,:))) < 1e-7);
end

## the emitted derivatives against central differences of order 6
function subroutines (m)
  d = m.sizes;
  x = m.initial + 0.1 * (1:d.nx)';
  if (d.nlam > 0)
    x = gsmbp_assemble (m, x, "hold", "q1");
  end
  [q, u, ud, v] = deal (x(1:d.nq), x(d.nq+(1:d.nu)), (1:d.nu)', 0.7 * ones (d.nv, 1));
  [P, A, B, xd] = m.rhp (0, x, v);
  [A2, B2] = m.jac (0, x, v);
  gsmbp_check ([m.name ": RHP has the Jacobians and rates of JAC and RHS"], ...
               norm (A - A2, 1) < 1e-13 * norm (A2, 1) ...
               && norm (B - B2, 1) < 1e-13 * (1 + norm (B2, 1)) ...
               && norm (xd - m.rhs (0, x, v)) < 1e-13 * norm (xd));
  pairs = {"RHP", P, @(m) m.rhs(0, x, v); "OUP", m.oup(0, x, v), @(m) m.out(0, x, v); ...
           "INP", m.inp(0, q, u, ud, v), @(m) m.inv(0, q, u, ud, v)};
  if (d.nlam > 0)
    [PP, PV] = m.cop (0, x);
    pairs = [pairs; {"COP", PP, @(m) m.con(0, q, u); "COP, rates", PV, @(m) rates(m, q, u)}];
  end
  names = cellstr (m.json.sensitivity)(:)';
  for pair = pairs'
    D = cell2mat (cellfun (@(p) differenced (pair{3}, m, p), names, "UniformOutput", false));
    e = max (max (abs (pair{2} - D)) ./ max (1, max (abs (D))));
    gsmbp_check (sprintf ("%s: %s is what differences give, found %.2g", m.name, pair{1}, e), ...
                 e < 1e-9);
  end
end

function r = rates (m, q, u)
  [~, r, H] = m.con (0, q, u);
  r += H * u;
end

function D = differenced (f, m, p, step = 1e-3)
  h = step * m.par.(p);
  g = @(s) f (gsmbp_set (m, p, m.par.(p) + s * h));
  D = (45 * (g(1) - g(-1)) - 9 * (g(2) - g(-2)) + (g(3) - g(-3))) / (60 * h);
end

## a loop: the start that follows the lengths, and the run, against differences of runs
function crank (m)
  names = {"l2", "rho", "km"};
  run = @(m) gsmbp_simulate (m, closed (m), [0 0.1 0.3], "input", 12, "rtol", 1e-13);
  r = gsmbp_simulate (m, closed (m), [0 0.1 0.3], "input", 12, "sensitivity", names, "rtol", 1e-11);
  for p = names
    D = differenced (@(m) [run(m).x, run(m).y], m, p{1});
    found = [r.dx.(p{1}), r.dy.(p{1})];
    e = norm (found - D, Inf) / norm (D, Inf);
    gsmbp_check (sprintf ("slider-crank: dx, dy by %s as by differences, found %.2g", p{1}, e), ...
                 e < 1e-8);
  end
  x = r.x(3,:)';
  [DP, DV] = m.tan (0.3, x);
  [PP, PV] = m.cop (0.3, x);
  [~, ~, H] = m.con (0.3, x(1:3), x(4:6));
  k = find (strcmp (cellstr (m.json.sensitivity), "l2"));
  s = r.dx.l2(3,:)';
  gsmbp_check ("they stay on the derivatives of the constraints", ...
               norm (DP * s(1:3) + PP(:,k)) < 1e-12 ...
               && norm (DV * s(1:3) + H * s(4:6) + PV(:,k)) < 1e-11);
end

## ILP: efforts, multipliers, followers of a planned crank, against differences of order 6
function along_a_motion (m)
  plan = gsmbp_plan ("septic", [0.3 2], [0 1]);
  names = cellstr (m.json.sensitivity)(:)';
  r = gsmbp_inverse (m, plan, 0.4);
  D = m.ilp (0.4, r.q, r.u, r.ud, 0, r.tau, r.lambda);
  others = [2 3 5 6 8 9 10:12];
  found = -D(:,others) \ D(:,13:end);
  at = @(m) followed (gsmbp_inverse (m, plan, 0.4));
  expected = cell2mat (cellfun (@(p) differenced (at, m, p), names, "UniformOutput", false));
  e = max (max (abs (found - expected)) ./ max (abs (expected)));
  gsmbp_check (sprintf ("ILP: a motion of a loop by parameters as by differences, found %.2g", ...
                        e), e < 1e-8);
  h = 1e-4;
  moved = @(s) gsmbp_inverse (m, gsmbp_plan ("septic", [0.3 2] + s, [0 1]), 0.4);
  by_start = -D(:,others) \ D(:,1);
  slope = (followed (moved (h)) - followed (moved (-h))) / (2 * h);
  e = max (abs (by_start - slope)) / max (abs (slope));
  gsmbp_check (sprintf ("ILP: the same by the planned coordinate, found %.2g", e), e < 1e-6);
end

function f = followed (r)
  f = [r.q(2:3)'; r.u(2:3)'; r.ud(2:3)'; r.tau'; r.lambda'];
end

## inputs that follow the states or the time, against differences; the same run by BDF
function inputs (m)
  K = [3 0 0 0.4 0 0 0.1];
  z = [1; 0; 0; 2; 0; 0; 0];
  cases = {"a function of time", {"input", @(t, x) 12 * cos(t)}; ...
           "feedback", {"input", 12, "gain", K, "reference", z}; ...
           "feedback within limits", {"input", 12, "gain", K, "reference", z, "limits", 13}; ...
           "a gain that jumps", {"gain", mkpp([0 0.17 1], [K'; 2 * K'], 7), "reference", z}};
  for one = cases'
    run = @(m) gsmbp_simulate (m, closed (m), [0 0.1 0.3], one{2}{:}, "rtol", 1e-13);
    r = gsmbp_simulate (m, closed (m), [0 0.1 0.3], one{2}{:}, "sensitivity", {"rho", "km"});
    for p = {"rho", "km"}
      D = differenced (@(m) [run(m).x, run(m).y], m, p{1});
      e = norm ([r.dx.(p{1}), r.dy.(p{1})] - D, Inf) / norm (D, Inf);
      gsmbp_check (sprintf ("%s: dx, dy by %s as by differences, found %.2g", one{1}, p{1}, e), ...
                   e < 1e-8);
    end
  end
  if (! gsmbp_has_sundials ())
    return;
  end
  a = gsmbp_simulate (m, closed (m), [0 0.3], "input", 12, "sensitivity", {"la", "n"});
  b = gsmbp_simulate (m, closed (m), [0 0.3], "input", 12, "sensitivity", {"la", "n"}, ...
                      "method", "cvode");
  e = norm ([a.dx.la - b.dx.la; a.dx.n - b.dx.n], Inf) / norm ([a.dx.la; a.dx.n], Inf);
  gsmbp_check (sprintf ("cvode carries them too, found %.2g", e), e < 1e-8);
end

## inputs of a planned motion, alone and with feedback, of a loop: with the inductance through the
## rates of its efforts
function planned (m)
  plan = gsmbp_plan ("septic", [0.3 2], [0 0.5]);
  K = [30 0 0 2 0 0 0.1];
  cases = {"a planned motion, by radau", {"method", "radau"}; ...
           "with feedback within limits", {"gain", K, "reference", closed(m), "limits", 20}};
  names = {"l2", "rho", "n", "la", "km"};
  for one = cases'
    run = @(m, varargin) gsmbp_simulate (m, closed (m), [0 0.2 0.4], "motion", plan, "rtol", ...
                                         1e-13, one{2}{:}, varargin{:});
    r = run (m, "sensitivity", names);
    e = carried_off (r, names, @(m) run (m), m);
    gsmbp_check (sprintf ("%s: dx, dv, dy as by differences, found %.2g", one{1}, e), e < 1e-7);
  end
end

## a state that follows the plan by itself
function beside_a_plan (m)
  plan = gsmbp_plan ("septic", [0.2 1.4], [0 1]);
  cases = {"bristles on a planned motion", {}; ...
           "with feedback", {"gain", [40 5 0 0], "reference", [0.5; 0; 0; 0]}};
  names = {"m", "l", "n", "la", "fc"};
  for one = cases'
    run = @(m, varargin) gsmbp_simulate (m, [0.25; 0; 3; 1e-4], [0 0.3 0.6], "motion", plan, ...
                                         "rtol", 1e-13, one{2}{:}, varargin{:});
    e = carried_off (run (m, "sensitivity", names), names, @(m) run (m), m);
    gsmbp_check (sprintf ("%s: dx, dv, dy as by differences, found %.2g", one{1}, e), e < 1e-7);
  end
end

## the worst of dx, dv, dy by these names beside differences
function worst = carried_off (r, names, run, m)
  worst = 0;
  for p = names
    D = differenced (@(m) all_of (run (m)), m, p{1}, 1e-2);
    S = [r.dx.(p{1}), r.dv.(p{1}), r.dy.(p{1})];
    width = cellfun (@columns, {r.x, r.v, r.y});
    for part = mat2cell ([D; S], 2 * rows (D), width)
      [d, s] = deal (part{1}(1:end/2,:), part{1}(end/2+1:end,:));
      worst = max (worst, norm (d - s, Inf) / (norm (d, Inf) + eps));
    end
  end
end

function y = all_of (r)
  y = [r.x, r.v, r.y];
end

function x = closed (m)
  x = gsmbp_assemble (m, [0.3 -0.1 0.7 2 0 0 0.5], "hold", "q1");
end

## columns of start values are those of the flow
function start_values (m)
  r = gsmbp_simulate (m, [1.2, -0.5], [0 1], "sensitivity", {"theta", "m"}, "rtol", 1e-12, ...
                      "dx0", [0 0.5; 0 0]);
  g = @(s) gsmbp_simulate (m, [1.2 + s, -0.5], [0 1], "rtol", 1e-13).x(2,:);
  h = 1e-3;
  D = (45 * (g(h) - g(-h)) - 9 * (g(2*h) - g(-2*h)) + (g(3*h) - g(-3*h))) / (60 * h);
  gsmbp_check ("by a start value, as by differences", norm (r.dx.theta(2,:) - D) < 1e-9);
  alone = gsmbp_simulate (m, [1.2, -0.5], [0 1], "sensitivity", "m", "rtol", 1e-12);
  gsmbp_check ("dx0: a start that moves with the parameter", ...
               norm (r.dx.m(2,:) - alone.dx.m(2,:) - 0.5 * r.dx.theta(2,:)) < 1e-10);
end

function refused (m)
  x = closed (m);
  go = @(varargin) gsmbp_simulate (m, x, [0 0.1], varargin{:});
  cases = {{"sensitivity", "nothing"}, "or states, for their start values; found nothing"; ...
           {"sensitivity", "l1", "loops", "partitioning"}, "the way \"partitioning\""; ...
           {"sensitivity", "l1", "input", @(t, x) x(1)}, "that may depend on the states"; ...
           {"sensitivity", "l1", "fixed", {"q1", "q2"}}, "expected 1 of the coordinates"; ...
           {"sensitivity", {"l1", "l1"}}, "l1 is given twice"; ...
           {"sensitivity", "l1", "dx0", 1}, "expected 7 x 1 numbers"; ...
           {"dx0", 1}, "option dx0 needs option sensitivity"};
  for one = cases'
    gsmbp_check (["refused: " one{2}], ...
                 any (strfind (gsmbp_complaint (@() go (one{1}{:})), one{2})));
  end
  event = gsmbp_fixture ("event_ball");
  gsmbp_check ("a scene with events has no RHP", ...
               any (strfind (gsmbp_complaint (@() gsmbp_simulate (event, event.initial, [0 1], ...
                             "sensitivity", "m")), "without the subroutine RHP")));
end

## an equilibrium that a motor holds, and its poles, against differences of others
function equilibrium (m)
  words = {"hold", "q1", "free", "motor.v"};
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0.7], "hold", "q1");
  rest = @(m) gsmbp_trim (m, gsmbp_assemble (m, x0, "hold", "q1"), 0, words{:}, ...
                          "tolerance", 1e-13);
  at = @(m, e) gsmbp_sensitivity (m, e.x, e.v, words{:});
  e = rest (m);
  s = at (m, e);
  for p = {"l1", "n"}
    D = differenced (@(m) whole (m, rest (m), at), m, p{1});
    found = {[s.dx.(p{1}); s.dv.(p{1}); s.dy.(p{1})], s.dpoles.(p{1})};
    k = numel (found{1});
    off = @(a, b) norm (a - b) / norm (b);
    wrong = [off(found{1}, D(1:k)), off(found{2}, D(k+1:end))];
    gsmbp_check (sprintf ("equilibrium and poles by %s, found %.2g, %.2g", p{1}, wrong), ...
                 wrong(1) < 1e-9 && wrong(2) < 1e-7);
  end
  says = @(f, text) gsmbp_check (["refused: " text], ...
                                 any (strfind (gsmbp_complaint (f), text)));
  says (@() gsmbp_sensitivity (m, e.x, e.v, "hold", "q1"), "there is no equilibrium near this one");
  says (@() gsmbp_sensitivity (m, e.x, e.v, "free", "motor.v"), "does not stand alone");
  says (@() gsmbp_sensitivity (m, e.x, 0, words{:}), "expected an equilibrium");
  says (@() gsmbp_sensitivity (m, e.x, e.v, "hold", "q9"), "unknown name");
end

function y = whole (m, e, at)
  y = [e.x; e.v; m.out(0, e.x, e.v); at(m, e).poles];
end

## the pendulum about its rest, by hand
function frequency (m)
  s = gsmbp_sensitivity (m, [0 0], []);
  J = 0.05 + 1.3 * 0.16;
  w = sqrt ((1.3 * 9.81 * 0.4 + 0.7) / J);
  gsmbp_check ("frequency and damping of the pendulum by spring and damper", ...
               norm ([s.frequency - w, s.dfrequency.k - 1/(2*w*J), s.ddamping.d - 1/(2*w*J)]) ...
               < 1e-12);
end

## ADJ against RHP, and the adjoint of a run against the columns that a run carries; an input in
## pieces
function backwards (m, x, v, T)
  d = m.sizes;
  [P, A, B] = m.rhp (0, x, v);
  L = (1:d.nx)' / 3;
  [xb, vb, pb] = m.adj (0, x, v, L);
  off = norm ([xb - A' * L; vb - B' * L; pb - P' * L]) / norm ([xb; vb; pb]);
  gsmbp_check (sprintf ("%s: ADJ is RHP transposed, found %.2g", m.name, off), off < 1e-13);
  if (d.nv > 0)
    v = gsmbp_plan ("table", [0 0.13 T], [5 12 9], 0);
  end
  times = sort ([linspace(0, T, 5), 0.13]);   # at the jump, too
  a = gsmbp_adjoint (m, x, times, @(r) goals (r, d), "input", v, "rtol", 1e-11);
  r = gsmbp_simulate (m, x, times, "input", v, "sensitivity", cellstr (m.json.sensitivity)', ...
                      "rtol", 1e-12);
  worst = 0;
  for p = fieldnames (r.dx)'
    e = [r.dx.(p{1})(end,1); 2 * r.y(:,1)' * r.dy.(p{1})(:,1)];
    worst = max ([worst; abs(e - a.dJ.(p{1})) ./ max(1e-3, abs (e))]);
  end
  gsmbp_check ([m.name ": its inputs and outputs are those of the run"], ...
               isequal (a.run.v, r.v) && norm (a.run.y - r.y) <= 1e-6 * norm (r.y));
  gsmbp_check (sprintf ("%s: the adjoint has the derivatives of a run, found %.2g", m.name, ...
                        worst), worst < 1e-8);
end

function [J, Jx, Jy] = goals (r, d)
  n = numel (r.t);
  J = [r.x(end,1); sum(r.y(:,1) .^ 2)];
  Jx = zeros (n, d.nx, 2);
  Jx(n,1,1) = 1;
  Jy = zeros (n, d.ny, 2);
  Jy(:,1,2) = 2 * r.y(:,1);
end

function adjoint_refused (m)
  says = @(f, text) gsmbp_check (["refused: " text], ...
                                 any (strfind (gsmbp_complaint (f), text)));
  says (@() gsmbp_adjoint (m, closed (m), [0 0.1], @(r) deal (1, 1)), "goal: expected Jx");
  says (@() gsmbp_adjoint (m, closed (m), [0 0.1], 3), ...
        "argument goal: expected a function [J, Jx, Jy] = goal (r), found 3");
  says (@() gsmbp_adjoint (m, closed (m), [0 0.1], @(r) r.x(end,1)), ...
        "or [J, Jx], found one with fewer results");
  says (@() gsmbp_adjoint (gsmbp_fixture ("event_ball"), 0, [0 0.1], @(r) deal (1, 1)), ...
        "without the subroutine ADJ");
end
