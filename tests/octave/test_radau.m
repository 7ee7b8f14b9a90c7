## Collocation of Radau against dp853 at a much smaller tolerance: outputs between the steps, inputs
## of every kind, loops in their ways, samples, hydraulics; failures.

function test_radau ()
  warning ("off", "gsmbp:stiff", "local");
  axis = gsmbp_set (gsmbp_hand ("motor_pendulum"), "L_a", 2e-4);
  tolerance (axis);
  outputs (axis);
  inputs (axis);
  feedback (gsmbp_hand ("motor_pendulum"));
  crank (gsmbp_set (gsmbp_fixture ("case_02a_motor"), "La", 2e-4));
  no_jacobian (gsmbp_hand ("hand_crank"));
  bodies (gsmbp_fixture ("orient_free"), gsmbp_fixture ("redundant_bricard"));
  sampled (gsmbp_fixture ("sampled_drive"));
  hydraulic (gsmbp_fixture ("fluid_hydraulic"));
  failures (axis);
end

function r = truth (m, x0, t, varargin)
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-13, "atol", 1e-13, varargin{:});
end

function varargout = radau (m, x0, t, varargin)
  [varargout{1:nargout}] = gsmbp_simulate (m, x0, t, "method", "radau", varargin{:});
end

## an electrical pole of 8e3 1/s
function tolerance (m)
  t = [0, 0.3, 1];
  exact = truth (m, [2; 0; 0], t, "input", 1);
  for k = 1:6
    r = radau (m, [2; 0; 0], t, "input", 1, "rtol", 10 ^ -(2 * k));
    e(k) = state_gap (r, exact);
    calls(k) = r.stats.calls;
  end
  gsmbp_check (sprintf ("error over tolerance, 1e-2 to 1e-12 (calls %s)", num2str (calls)), ...
               e ./ 10 .^ -(2:2:12), 100);
  gsmbp_check (sprintf ("%d Newton iterations, %d Jacobians in %d steps", r.stats.newton, ...
                        r.stats.jacobians, r.stats.accepted), ...
               r.stats.newton < 6 * r.stats.accepted && r.stats.jacobians > 0);
end

## outputs between the steps; no step beyond maxstep
function outputs (m)
  few = radau (m, [0.2; 0; 0], 0:0.1:1, "input", 3);
  many = radau (m, [0.2; 0; 0], 0:0.001:1, "input", 3);
  gsmbp_check ("1000 output times or 10, same steps", many.x(1:100:end,:) - few.x, 1e-13);
  exact = truth (m, [0.2; 0; 0], 0:0.001:1, "input", 3);
  gsmbp_check ("between the steps", state_gap (many, exact), 1e-8);
  short = radau (m, [0.2; 0; 0], [0, 1], "input", 3, "maxstep", 1e-3);
  gsmbp_check ("no step beyond maxstep", short.stats.largest_step <= 1e-3 * (1 + 1e-12) ...
                 && short.stats.accepted >= 1000);
end

function inputs (m)
  t = 0:0.25:1;
  v = @(t) 3 * sin (5 * t);
  s = (0:0.001:1)';
  exact = truth (m, [0.2; 0; 0], t, "input", @(t, x) v (t));
  for way = {{gsmbp_plan("table", s, v(s), 3), "a cubic table"}, {@(t, x) v(t), "a callback"}}
    r = radau (m, [0.2; 0; 0], t, "input", way{1}{1});
    gsmbp_check (["inputs by " way{1}{2}], state_gap (r, exact), 1e-8);
    gsmbp_check (["inputs by " way{1}{2} " are recorded"], r.v - v (t'), 1e-9);
  end
  plan = gsmbp_plan ("septic", [0.2, 1.5], [0, 1]);
  r = radau (m, gsmbp_inverse (m, plan, 0).x', t, "motion", plan);
  gsmbp_check ("open loop along a planned motion, rad", r.x(:,1)' - gsmbp_evaluate (plan, t), 1e-8);
  wave = gsmbp_plan ("table", [0, 0.131, 0.377, 0.7, 1], [5; -5; 5; 0; 0], 0);
  t = [0, 0.131, 0.1311, 0.5, 1];
  exact = truth (m, [0.2; 0; 0], t, "input", wave);
  r = radau (m, [0.2; 0; 0], t, "input", wave);
  gsmbp_check ("jumps of the input: all states", state_gap (r, exact), 1e-8);
  gsmbp_check ("jumps of the input: recorded from the left", r.v - exact.v, 0);
end

## high gain on the current: the Jacobian needs the inputs' slope
function feedback (m)
  options = {"input", 1, "gain", [20, 4, 30], "reference", [0.1; 0; 0]};
  exact = truth (m, [0.3; 0; 1], 0:0.1:1, options{:});
  r = radau (m, [0.3; 0; 1], 0:0.1:1, options{:});
  gsmbp_check (sprintf ("state feedback (%d Newton iterations, %d steps)", r.stats.newton, ...
                        r.stats.accepted), state_gap (r, exact), 1e-9);
end

function crank (m)
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  t = 0:0.05:0.5;
  exact = truth (m, x0, t, "input", 5);
  for way = {"projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"}
    r = radau (m, x0, t, "input", 5, "loops", way{1});
    gsmbp_check (sprintf ("slider-crank, %s: %d calls; all states", way{1}, r.stats.calls), ...
                 state_gap (r, exact), 1e-8);
    if (! strcmp (way{1}, "baumgarte"))
      gsmbp_check (sprintf ("slider-crank, %s: drift, m and m/s", way{1}), ...
                   [r.stats.drift.phi, r.stats.drift.phidot], 1e-13);
    end
  end
end

function no_jacobian (m)
  x0 = gsmbp_assemble (m, [0.3, -0.1, 0.7, 12, 0, 0], "hold", "q1");
  t = 0:0.1:0.5;
  r = radau (m, x0, t, "input", 1, "rtol", 1e-11);
  gsmbp_check ("a scene without JAC", state_gap (r, truth (m, x0, t, "input", 1)), 1e-8);
end

## Euler parameters; four of five rows independent
function bodies (free, bricard)
  x0 = [0.1; 0.2; 0.3; 1; 0; 0; 0; 1; -2; 0.5; 2; 1; -3];
  r = radau (free, x0, 0:0.1:1);
  gsmbp_check ("Euler parameters: all states", state_gap (r, truth (free, x0, 0:0.1:1)), 1e-8);
  gsmbp_check ("Euler parameters: their norm", sqrt (sumsq (r.x(:,4:7), 2)) - 1, 1e-14);
  closed = @(a) [a; acos(-cos (a) / (1 + cos (a)))]([1, 2, 1, 2, 1]);
  x0 = [closed(1); zeros(5, 1)];
  r = radau (bricard, x0, 0:0.1:1);
  gsmbp_check ("Bricard: all states", state_gap (r, truth (bricard, x0, 0:0.1:1)), 1e-8);
end

function sampled (m)
  t = 0:0.05:2;
  exact = truth (m, [0; 0], t, "input", 1);
  r = radau (m, [0; 0], t, "input", 1);
  gsmbp_check ("digital controller: all states", state_gap (r, exact), 1e-8);
  gsmbp_check ("digital controller: instants and what is held", ...
               isequal (r.samples.t, exact.samples.t) ...
                 && max (max (abs (r.samples.v - exact.samples.v))) < 1e-6);
end

## pressures of 1e7 Pa beside a spool of 1e-4 m
function hydraulic (m)
  t = 0:0.05:0.3;
  u = {"input", [2e-4, 0.02]};
  exact = gsmbp_simulate (m, m.initial, t, u{:}, "rtol", 1e-12);
  r = radau (m, m.initial, t, u{:}, "rtol", 1e-9);
  gsmbp_check (sprintf ("hydraulic axes (%d calls): all states, of their nominal sizes", ...
                        r.stats.calls), (r.x - exact.x) ./ m.nominal', 1e-7);
end

function failures (m)
  [r, info] = radau (m, [1; 0; 0], 0:0.01:1, "input", 3, "maxsteps", 10);
  gsmbp_check ("the limit of steps is reported, the rows before are kept", ...
               info == 1 && numel (r.t) >= 1 && numel (r.t) < 101);
  [r, info] = radau (m, [1; 0; 0], 0:0.1:1, "input", @(t, x) 1e300 * (t > 0.55));
  gsmbp_check ("states that cease to be finite: the rows before are kept", ...
               info != 0 && numel (r.t) == 6 && all (isfinite (r.x(:))));
  for wrong = {{"input", @(t, x) Inf}, {"maxorder", 7}, {"maxorder", 6}}
    said = "";
    try
      radau (m, [1; 0; 0], [0, 1], wrong{1}{:});
    catch err
      said = err.message;
    end
    printf ("   (%s)\n", said);
    gsmbp_check (["refused: " wrong{1}{1}], strncmp (said, "gsmbp_simulate: ", 16));
  end
end
