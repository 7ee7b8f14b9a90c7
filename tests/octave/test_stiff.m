## Stiff scenes: CVODE against dp853 at a much smaller tolerance; inputs of every kind; loops in all
## ways; the warnings of the explicit methods against the eigenvalues of the exact Jacobian; "auto";
## failures.

function test_stiff ()
  warning ("off", "gsmbp:stiff", "local");
  axis = gsmbp_hand ("motor_pendulum");
  single_axis (axis);
  tolerance (axis);
  bounds (axis);
  looks (axis);
  swinging (gsmbp_fixture ("trim_stiff"));
  inputs (axis);
  jumps (axis);
  feedback (axis);
  automatic (axis);
  crank (gsmbp_fixture ("case_02a_motor"));
  no_jacobian (gsmbp_hand ("hand_crank"));
  euler_parameters (gsmbp_fixture ("orient_free"));
  redundant (gsmbp_fixture ("redundant_bricard"));
  sampled (gsmbp_fixture ("sampled_drive"));
  hydraulic (gsmbp_fixture ("fluid_hydraulic"));
  failures (axis);
  nominal (axis);
  without_sundials (axis);
end

## the motor with L = 0.02 mH: electrical pole 8e4 1/s
function m = fast (m)
  m = gsmbp_set (m, "L_a", 2e-5);
end

function r = truth (m, x0, t, varargin)
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-13, "atol", 1e-13, varargin{:});
end

function varargout = stiff (m, x0, t, varargin)
  [varargout{1:nargout}] = gsmbp_simulate (m, x0, t, "method", "cvode", varargin{:});
end

function single_axis (m)
  m = fast (m);
  x0 = [0.2; 0; 0];
  t = 0:0.1:1;
  exact = truth (m, x0, t, "input", 3);
  explicit = gsmbp_simulate (m, x0, t, "input", 3);
  c = stiff (m, x0, t, "input", 3);
  ## errors of 500 steps at 1e-10 add up
  gsmbp_check ("one axis, pole 8e4 1/s: cvode, all states", state_gap (c, exact), 1e-8);
  gsmbp_check (sprintf ("one axis: %d calls of the right-hand side, dp853 %d", c.stats.calls, ...
                        explicit.stats.calls), c.stats.calls < 0.02 * explicit.stats.calls);
  gsmbp_check (sprintf ("one axis: %d Jacobians, %d Newton iterations in %d steps", ...
                        c.stats.jacobians, c.stats.newton, c.stats.accepted),
               c.stats.jacobians > 0 && c.stats.jacobians < 0.1 * c.stats.accepted ...
                   && c.stats.newton < 2 * c.stats.accepted);
  ## between its steps the state comes from BDF's own polynomial
  many = stiff (m, x0, 0:0.001:1, "input", 3);
  gsmbp_check ("one axis: 1000 output times or 10, same steps", many.x(1:100:end,:) - c.x, 1e-14);
  gsmbp_check ("one axis: time reached less 1 s", many.stats.reached - 1, 0);
end

function tolerance (m)
  m = fast (m);
  x0 = [2; 0; 0];
  exact = truth (m, x0, [0, 0.3, 1], "input", 1);
  tols = 10 .^ -(4:2:12);
  for k = 1:numel (tols)
    r = stiff (m, x0, [0, 0.3, 1], "input", 1, "rtol", tols(k));
    e(k) = state_gap (r, exact) / tols(k);
    calls(k) = r.stats.calls;
  end
  gsmbp_check (sprintf ("cvode: error over tolerance, 1e-4 to 1e-12 (calls %s)", ...
                        num2str (calls)), e, 300);
  second = stiff (m, x0, [0, 0.3, 1], "input", 1, "rtol", 1e-6, "maxorder", 2);
  gsmbp_check ("cvode: order two at most, a tolerance of 1e-6", state_gap (second, exact), 1e-4);
end

## what the explicit methods say, against the exact eigenvalue
function bounds (m)
  m = fast (m);
  x0 = [0.2; 0; 0];
  pole = max (abs (eig (m.jac (0, x0, 3))));
  [r, info] = gsmbp_simulate (m, x0, [0, 1], "input", 3, "method", "rk4", "step", 1e-3);
  s = r.stats.stiff;
  gsmbp_check ("rk4 beyond its limit: fails", info != 0);
  gsmbp_check ("rk4 beyond its limit: reported at the start, the current", ...
               s.time == 0 && s.step == 1e-3 && strcmp (s.state, "drive.i"));
  gsmbp_check (sprintf ("rk4 beyond its limit: eigenvalue %.5g 1/s, relative", s.eigenvalue), ...
               s.eigenvalue / pole - 1, 0.02);
  step = @(z) gsmbp_simulate (m, x0, [0, 0.01], "input", 3, "method", "rk4", "step", z / pole);
  inside = step (2.7);
  [beyond, ~] = gsmbp_simulate (m, x0, [0, 0.01], "input", 3, "method", "rk4", "step", ...
                                0.01 / ceil (0.01 * pole / 2.9));
  gsmbp_check ("rk4: silent at 2.7, heard at 2.9 over the eigenvalue", ...
               isnan (inside.stats.stiff.time) && ! isnan (beyond.stats.stiff.time));
  gsmbp_check ("rk4: the calls that look for bounds are not counted", ...
               inside.stats.calls == 4 * inside.stats.accepted);
  s = gsmbp_simulate (m, x0, [0, 1], "input", 3).stats.stiff;
  gsmbp_check (sprintf (["dp853 bound by stability: heard at %.4f s, step %.2g over the " ...
                         "eigenvalue"], ...
                        s.time, s.step * pole), s.step * pole > 4 && s.step * pole < 8);
  gsmbp_check ("dp853 bound by stability: eigenvalue, relative", s.eigenvalue / pole - 1, 0.02);
  slow = gsmbp_set (m, "L_a", 0.0048);
  for run = {{}, {"method", "rk4"}}
    r = gsmbp_simulate (slow, x0, [0, 5], "input", 3, run{1}{:});
    gsmbp_check (sprintf ("L = 4.8 mH, %s: nothing to report", r.stats.method), ...
                 isnan (r.stats.stiff.time));
  end
  ## the printed warning, with its remedy
  warning ("on", "gsmbp:stiff", "local");
  lastwarn ("");
  gsmbp_simulate (m, x0, [0, 0.1], "input", 3);
  [text, id] = lastwarn ();
  gsmbp_check ("the warning names time, state and remedy", ...
               strcmp (id, "gsmbp:stiff") ...
                 && ! isempty (regexp (text, ...
                                 'at t = .*1/s, of drive\.i.*method "radau".*reduced variant')));
end

## a look at the bound far from it ends after a few calls of the right-hand side
function looks (m)
  m = gsmbp_set (m, "L_a", 0.0048);
  x0 = [0.2; 0; 0];
  h = 0.05 / max (abs (eig (m.jac (0, x0, 3))));
  counted (0);
  r = gsmbp_simulate (m, x0, [0, 10 * h], "input", @(t, x) counted (3), "method", "rk4", "step", h);
  more = counted (0) - r.stats.calls;
  gsmbp_check (sprintf ("rk4 far inside its limit: %d calls beside the %d of 10 steps", more, ...
                        r.stats.calls), r.stats.calls == 40 && more <= 10);
end

## the constant V; 0 begins to count again, and gives how often there was another one
function v = counted (v)
  persistent n = 0;
  if (v == 0)
    [v, n] = deal (n, 0);
  else
    n++;
  end
end

## undamped springs, frequencies of 1 to 1e5 1/s: the bound by the fastest of them
function swinging (m)
  x0 = zeros (m.sizes.nx, 1);
  x0(m.sizes.nq) = 1;
  largest = max (abs (eig (m.jac (0, x0))));
  for z = [2.5, 3.1]
    h = z / largest;
    [r, ~] = gsmbp_simulate (m, x0, [0, 2 * h], "method", "rk4", "step", h * (1 + 1e-9));
    heard = r.stats.stiff.eigenvalue;
    gsmbp_check (sprintf ("springs, rk4 at %g over the eigenvalue %.3g: %.3g 1/s", z, largest, ...
                          heard), ...
                 isnan (heard) == (z < 2.8) && ! (abs (heard / largest - 1) > 0.05));
  end
end

function inputs (m)
  m = fast (m);
  x0 = [0.2; 0; 0];
  t = 0:0.25:1;
  v = @(t) 3 * sin (5 * t);
  s = (0:0.001:1)';
  table = gsmbp_plan ("table", s, v (s), 3);
  source = user_input ();
  guard = onCleanup (@() unlink (source));
  own = fast (gsmbp_hand ("motor_pendulum", "input", source));
  exact = truth (own, x0, t, "input", "user");
  gsmbp_check ("inputs: by a Fortran subroutine", ...
               state_gap (stiff (own, x0, t, "input", "user"), exact), 1e-7);
  gsmbp_check ("inputs: by callback", ...
               state_gap (stiff (m, x0, t, "input", @(t, x) v (t)), exact), 1e-7);
  c = stiff (m, x0, t, "input", table);
  gsmbp_check ("inputs: by a cubic table", state_gap (c, exact), 1e-8);
  gsmbp_check (sprintf ("inputs: no new start at the 999 breaks of a smooth table (%d calls)", ...
                        c.stats.calls), c.stats.calls < 5000);
  gsmbp_check ("inputs: are recorded", c.v - v (t'), 1e-9);
  plan = gsmbp_plan ("septic", [0.2, 1.5], [0, 1]);
  start = gsmbp_inverse (m, plan, 0).x';
  c = stiff (m, start, t, "motion", plan);
  gsmbp_check ("inputs: open loop along a planned motion, rad", ...
               c.x(:,1)' - gsmbp_evaluate (plan, t), 1e-8);
  failed = "";
  try
    stiff (m, x0, t, "input", @(t, x) error ("no input here"));
  catch err
    failed = err.message;
  end
  gsmbp_check ("inputs: an error in the callback arrives", ...
               ! isempty (strfind (failed, "no input here")));
end

## a square wave: the integration stops at the jumps and starts again
function jumps (m)
  m = fast (m);
  wave = gsmbp_plan ("table", [0, 0.131, 0.377, 0.7, 1], [5; -5; 5; 0; 0], 0);
  x0 = [0.2; 0; 0];
  t = [0, 0.131, 0.1311, 0.5, 1];
  exact = truth (m, x0, t, "input", wave);
  c = stiff (m, x0, t, "input", wave);
  gsmbp_check ("jumps of the input: all states", state_gap (c, exact), 1e-8);
  gsmbp_check ("jumps of the input: recorded from the left", c.v - exact.v, 0);
  exact = truth (m, x0, t, "input", gsmbp_plan ("table", [0, 0.131, 1], [5; -5; -5], 0));
  c = stiff (m, x0, t, "input", @(t, x) 5 - 10 * (t > 0.131), "breaks", 0.131);
  gsmbp_check ("jumps of a callback at option breaks", state_gap (c, exact), 1e-7);
end

## high gain on the current: stiff by its controller; the Jacobian needs the inputs' slope
function feedback (m)
  K = [20, 4, 30];
  x0 = [0.3; 0; 1];
  t = 0:0.1:1;
  options = {"input", 1, "gain", K, "reference", [0.1; 0; 0]};
  exact = truth (m, x0, t, options{:});
  c = stiff (m, x0, t, options{:});
  gsmbp_check ("state feedback", state_gap (c, exact), 1e-7);
  called = stiff (m, x0, t, "input", @(t, x) 1 - K * (x - [0.1; 0; 0]));
  gsmbp_check ("the same by a callback", state_gap (called, exact), 1e-7);
  for r = {c, called}
    gsmbp_check (sprintf ("state feedback: %d Newton iterations in %d steps", r{1}.stats.newton, ...
                          r{1}.stats.accepted), r{1}.stats.newton < 1.3 * r{1}.stats.accepted);
  end
end

function automatic (m)
  x0 = [0.2; 0; 0];
  t = 0:0.05:1;
  wave = {"input", gsmbp_plan("table", [0, 0.131, 0.377, 0.7, 1], [5; -5; 5; 0; 0], 0)};
  a = gsmbp_simulate (m, x0, t, wave{:}, "method", "auto");
  b = gsmbp_simulate (m, x0, t, wave{:});
  gsmbp_check ("auto, L = 4.8 mH: dp853 to the end", ...
               strcmp (a.stats.method, "dp853") && isequal (a.x, b.x));
  f = fast (m);
  a = gsmbp_simulate (f, x0, t, wave{:}, "method", "auto");
  exact = truth (f, x0, t, wave{:});
  b = gsmbp_simulate (f, x0, t, wave{:});
  gsmbp_check (sprintf ("auto, L = 0.02 mH: goes on with radau at %.4f s", a.stats.stiff.time), ...
               strcmp (a.stats.method, "radau"));
  gsmbp_check ("auto, L = 0.02 mH: all states", state_gap (a, exact), 1e-8);
  gsmbp_check ("auto, L = 0.02 mH: inputs recorded", ...
               isequal (a.v, exact.v) && isequal (a.t, exact.t));
  gsmbp_check (sprintf ("auto, L = 0.02 mH: %d calls, dp853 %d", a.stats.calls, b.stats.calls), ...
               a.stats.calls < 0.1 * b.stats.calls);
  warning ("on", "gsmbp:stiff", "local");
  lastwarn ("");
  gsmbp_simulate (f, x0, t, wave{:}, "method", "auto");
  gsmbp_check ("auto is silent", isempty (lastwarn ()));
end

## the slider-crank of case 02a, L = 0.02 mH
function crank (m)
  m = gsmbp_set (m, "La", 2e-5);
  x0 = gsmbp_assemble (m, [0.3; -0.1; 0; zeros(4, 1)]);
  t = 0:0.05:0.5;
  exact = truth (m, x0, t, "input", 5);
  explicit = gsmbp_simulate (m, x0, t, "input", 5);
  gsmbp_check ("stiff slider-crank: dp853 is heard", ! isnan (explicit.stats.stiff.time));
  for way = {"projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"}
    c = stiff (m, x0, t, "input", 5, "loops", way{1});
    s = c.stats;
    gsmbp_check (sprintf ("stiff slider-crank, %s: %d calls, dp853 %d; all states", way{1}, ...
                          s.calls, explicit.stats.calls), ...
                 state_gap (c, exact) + (s.calls > 0.1 * explicit.stats.calls), 2e-7);
    if (! strcmp (way{1}, "baumgarte"))
      gsmbp_check (sprintf ("stiff slider-crank, %s: drift, m and m/s", way{1}), ...
                   [s.drift.phi, s.drift.phidot], 1e-13);
      [q, u] = deal (c.x(6,1:3)', c.x(6,4:6)');
      [phi, phit, H] = m.con (t(6), q, u);
      gsmbp_check (sprintf ("stiff slider-crank, %s: closed between the steps", way{1}), ...
                   [phi; H * u + phit], 1e-13);
    end
  end
end

## CVODE's own difference quotients
function no_jacobian (m)
  x0 = gsmbp_assemble (m, [0.3, -0.1, 0.7, 12, 0, 0], "hold", "q1");
  t = 0:0.1:0.5;
  c = stiff (m, x0, t, "input", 1, "rtol", 1e-11);
  gsmbp_check ("a scene without JAC", state_gap (c, truth (m, x0, t, "input", 1)), 1e-6);
  gsmbp_check ("a scene without JAC: closed, m", c.stats.drift.phi, 1e-13);
end

function euler_parameters (m)
  x0 = [0.1; 0.2; 0.3; 1; 0; 0; 0; 1; -2; 0.5; 2; 1; -3];
  t = 0:0.1:1;
  c = stiff (m, x0, t);
  gsmbp_check ("Euler parameters: all states", state_gap (c, truth (m, x0, t)), 1e-7);
  gsmbp_check ("Euler parameters: their norm", sqrt (sumsq (c.x(:,4:7), 2)) - 1, 1e-14);
end

## four of five rows independent: the states are completed from independent ones
function redundant (m)
  closed = @(a) [a; acos(-cos (a) / (1 + cos (a)))]([1, 2, 1, 2, 1]);
  x0 = [closed(1); zeros(5, 1)];
  t = 0:0.1:1;
  c = stiff (m, x0, t);
  gsmbp_check (sprintf ("Bricard: %d steps; all states", c.stats.accepted), ...
               state_gap (c, truth (m, x0, t)), 1e-6);
  gsmbp_check ("Bricard: closed, m", c.stats.drift.phi, 1e-10);
end

## a digital controller: the run stops at its instants and starts again
function sampled (m)
  t = 0:0.05:2;
  exact = truth (m, [0; 0], t, "input", 1);
  c = stiff (m, [0; 0], t, "input", 1);
  gsmbp_check ("digital controller: all states", state_gap (c, exact), 1e-8);
  gsmbp_check ("digital controller: instants and what is held", ...
               isequal (c.samples.t, exact.samples.t) ...
                 && max (max (abs (c.samples.v - exact.samples.v))) < 1e-6);
end

## pressures of 1e7 Pa beside a spool of 1e-4 m: tolerances by the nominal sizes; 33 times fewer
## calls at least
function hydraulic (m)
  t = 0:0.05:0.3;
  u = {"input", [2e-4, 0.02]};
  gsmbp_check ("hydraulic axes: nominal sizes of the JSON", m.nominal - m.json.nominal(:), 0);
  exact = gsmbp_simulate (m, m.initial, t, u{:}, "rtol", 1e-11);
  c = stiff (m, m.initial, t, u{:}, "rtol", 1e-9);
  d = gsmbp_simulate (m, m.initial, t, u{:}, "rtol", 1e-9);
  gsmbp_check (sprintf ("hydraulic axes: eigenvalue %.2g 1/s of %s heard", ...
                        d.stats.stiff.eigenvalue, d.stats.stiff.state), ...
               d.stats.stiff.eigenvalue > 1e4);
  gsmbp_check ("hydraulic axes: all states, of their nominal sizes", ...
               (c.x - exact.x) ./ m.nominal', 1e-6);
  gsmbp_check (sprintf ("hydraulic axes: %d calls, dp853 %d", c.stats.calls, d.stats.calls), ...
               c.stats.calls < 0.03 * d.stats.calls);
end

function failures (m)
  m = fast (m);
  x0 = [1; 0; 0];
  [r, info] = stiff (m, x0, 0:0.01:1, "maxsteps", 300);
  gsmbp_check ("the limit of steps is reported, the rows before are kept", ...
               info == 1 && numel (r.t) > 1 && numel (r.t) < 101 && r.stats.accepted ...
                 + r.stats.rejected >= 300);
  [r, info] = stiff (m, x0, 0:0.1:1, "input", @(t, x) 1e300 * (t > 0.55));
  gsmbp_check ("states that cease to be finite: the rows before are kept", ...
               info != 0 && numel (r.t) == 6 && all (isfinite (r.x(:))));
  said = "";
  try
    stiff (m, [1; 0; 0], [0, 1], "input", @(t, x) 1e300);
  catch err
    said = err.message;
  end
  printf ("   (%s)\n", said);
  gsmbp_check ("CVODE's words and the time are in the error", ...
               ! isempty (regexp (said, 'the method stopped at t = 0 s with flag -\d+: .*[a-z]')));
  for wrong = {{"method", "bdf"}, {"method", "cvode", "maxorder", 6}, ...
               {"method", "cvode", "rtol", 0}}
    failed = false;
    try
      gsmbp_simulate (m, x0, [0, 1], wrong{1}{:});
    catch err
      failed = ! isempty (strfind (err.message, "gsmbp_simulate: "));
    end
    gsmbp_check (sprintf ("refused: %s %s", wrong{1}{end-1}, num2str (wrong{1}{end})), failed);
  end
  failed = false;
  try
    gsmbp_simulate (gsmbp_hand ("motor_pendulum", "precision", "quad"), x0, [0, 1], "method", ...
                    "cvode");
  catch err
    failed = ! isempty (strfind (err.message, "works in double precision"));
  end
  gsmbp_check ("refused: cvode of a build in quad", failed);
end

## usual sizes of the states become absolute tolerances
function nominal (m)
  gsmbp_check ("nominal: 1 where the JSON says nothing", m.nominal - 1, 0);
  m = fast (m);
  m.nominal = [1; 1; 1e4];
  a = stiff (m, [0.2; 0; 0], [0, 1], "rtol", 1e-6);
  b = stiff (m, [0.2; 0; 0], [0, 1], "rtol", 1e-6, "atol", 1e-6 * [1, 1, 1e4]);
  gsmbp_check ("nominal: the default of atol is rtol times it", isequal (a.x, b.x));
end

function cleanup (folder)
  confirm_recursive_rmdir (false, "local");
  rmdir (folder, "s");
end

## a compiler that finds no headers stands for a machine without SUNDIALS: what does not ask for it
## is not touched
function without_sundials (m)
  folder = tempname ();
  mkdir (folder);
  mkdir (fullfile (folder, "common"));
  guard = onCleanup (@() cleanup (folder));
  archive = fullfile ("common", "libgsmbp.a");
  copyfile (fullfile (fileparts (fileparts (m.file)), archive), fullfile (folder, archive));
  m.file = fullfile (folder, m.name, "module.oct");   # the library's place is beside it
  gsmbp_simulate (m, [0.2; 0; 0], [0, 0.1]);
  gsmbp_check ("a run by dp853 builds nothing of SUNDIALS", ...
               numel (readdir (fullfile (folder, "common"))) == 3);
  old = getenv ("CC");
  back = onCleanup (@() setenv ("CC", old));
  setenv ("CC", "gcc -nostdinc");
  said = "";
  try
    stiff (m, [0.2; 0; 0], [0, 0.1]);
  catch err
    said = err.message;
  end
  gsmbp_check ("without SUNDIALS the error names the package", ...
               ! isempty (strfind (said, "libsundials-dev")));
end
