## A robot joint: what its motor needs for a motion through harmonic drive and friction, what a
## rigid model of the drive misses, and the same motion under a cascade controller with an encoder,
## continuous and sampled each millisecond; slow reversals. Everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## least time of some runs [s], for one second of motion
function s = seconds_of (m, x0, duration, varargin)
  s = Inf;
  for k = 1:5
    s = min (s, gsmbp_simulate (m, x0, [0 duration], varargin{:}).stats.seconds / duration);
  endfor
endfunction

## the scene with another variant of a device, derived and compiled in out/
function m = changed (name, before, after)
  text = strrep (fileread ("robot_joint.mac"), "\"robot_joint\"", ["\"" name "\""]);
  file = fullfile ("out", [name ".mac"]);
  fid = fopen (file, "w");
  fprintf (fid, "%srequests : [kinematics, rhs]$\n", strrep (text, before, after));
  fclose (fid);
  gsmbp_derive (file, "out");
  m = gsmbp_build (name, "directory", "out");
endfunction

## angle of the wave generator where it is at rest at the start of a plan
function theta = resting (m, plan)
  theta = fzero (@(theta) gsmbp_inverse (m, plan, 0, "internal", [theta; 0; 0]).x(4), [0 1]);
endfunction

## a piecewise polynomial and its rate, one beside the other
function p = with_rate (p)
  c = reshape (p.coefs, 1, p.pieces, p.order);
  rate = cat (3, zeros (1, p.pieces), c(:,:,1:end-1) .* reshape (p.order-1:-1:1, 1, 1, []));
  p = mkpp (p.breaks, [c; rate], 2);
endfunction

## the plan of a motion as reference of the motor: angle and speed, n times those of the joint, no
## voltage beside
function p = reference (plan, n)
  p = with_rate (plan);
  p = mkpp (p.breaks, [n * reshape(p.coefs, 2, p.pieces, p.order); zeros(1, p.pieces, p.order)], 3);
endfunction

## model, start and options of a run under control: encoder at the angle THETA of the motor,
## integral part at the voltage HELD
function run = controlled (kind, model, x0, theta, held, input, options)
  m = model.(kind);
  run = [{m, x0, "input", input}, options];
  if (strcmp (kind, "sampled"))
    run = [run, {"memory", [theta; 1; held / m.par.ks]}];
  else
    run{2} = [x0; theta; held / m.par.ks; held];
  endif
endfunction

## --------------------------------------------------------------- the models
printf ("derivation: %.1f s of processor time, Maxima's start included\n\n", ...
        gsmbp_derive ("robot_joint.mac"));
m = gsmbp_build ("robot_joint");
for name = {"continuous", "sampled"}
  gsmbp_derive (["robot_joint_" name{1} ".mac"], "out");
  model.(name{1}) = gsmbp_build (["robot_joint_" name{1}], "directory", "out");
endfor
n = 100;
plan = gsmbp_plan ("septic", [0 1.2], [0 1]);
t = (0:0.001:1)';   # the kinematic error passes by each 12 ms
accuracy = {"rtol", 1e-7, "atol", 1e-7};

## ------------------------------------------------- what the motion needs
## the flexspline is an internal state of the inverse: it begins where the wave generator is at rest
begin = resting (m, plan);
x0 = gsmbp_inverse (m, plan, 0, "internal", [begin; 0; 0]).x';
options = {"motion", plan, "rtol", 1e-6, "atol", 1e-6};
f = gsmbp_simulate (m, x0, t, options{:}, "audit", 50);
twist = f.x(:,3) / n - f.x(:,1);
printf (["1.2 rad in 1 s: up to %.1f V and %.1f A; the flexspline twists by up to " ...
         "%.2f mrad\n"], max (abs (f.v)), max (abs (f.x(:,5))), 1e3 * max (abs (twist)));
gsmbp_plot ("out/command.png", t, panel ([f.x(:,1), f.x(:,3) / n], {"joint", "motor / 100"}, ...
    "angle [rad]"), panel (f.v, {"motor"}, "voltage [V]"), ...
            panel (f.x(:,5), {"motor"}, "current [A]"), panel (1e3 * twist, {"flexspline"}, ...
                "twist [mrad]"), "title", "What the motion needs");

## ---------------------------------------------- open loop, energy
lifted = m.ene (0, f.x(end,:)', 0)(2) - m.ene (0, f.x(1,:)', 0)(2);
printf (["open loop, the command computed at every call: the joint is %.1e rad from the plan " ...
         "at most; %.2f ms for 1 s\n"], ...
        max (abs (f.x(:,1) - gsmbp_evaluate (plan, t)')), 1e3 * seconds_of (m, x0, 1, options{:}));
printf (["energy: %.2f J came in or were lost, %.2f J lifted; not found %.1e of " ...
         "what passed\n\n"], f.audit.passed(end), lifted, f.audit.error);

## ------------------------------------------------------ reduced variants
## each under the voltage that the model without kinematic error needs; the estimates are the
## library's, for the bandwidth of this plan (jerk over acceleration)
puts ("variants for 10 mrad of accuracy\n");
choice ("robot_joint.mac", "0.01, [omega_c = 7, amplitude = 1.2]");
## friction rises within a millisecond
points = [0:0.001:0.1, 0.11:0.01:0.89, 0.9:0.001:1, 1.001:0.001:1.02, 1.05:0.05:1.5];
wide = gsmbp_plan ("septic", [0 1.2 1.2], [0 1 1.5]);
plain = gsmbp_set (m, "ke", 0);
known = gsmbp_inverse (plain, wide, points, "internal", [resting(plain, plan); 0; 0]);
voltage = gsmbp_plan ("table", points, known.v, 3);
## the drive's variants beside the joint as it is, the others without the kinematic error, so that
## each starts where its model is at rest
gear = {"ke = ke)", m, x0};
motor = {"dc_motor(M,", plain, known.x(1,:)'};
friction = {"friction(F,", plain, known.x(1,:)'};
variants = ...
    {"H elastic", gear, "variant = elastic)", 1:5, voltage; "H rigid", gear, "variant = rigid)", ...
     [1 ...
      2 5], voltage; ...
            "M qs1", motor, "dc_motor(M, variant = qs1,", 1:4, with_rate(voltage); "M qs0", ...
                motor, "dc_motor(M, variant = qs0,", 1:4, voltage; ...
            "F coulomb", friction, "friction(F, variant = coulomb,", 1:5, voltage; "F viscous", ...
                friction, "friction(F, variant = viscous,", 1:5, voltage};
printf ("\n%-12s %26s %14s\n", "variant", "largest difference [mrad]", "ms for 1 s");
for v = variants'
  [before, full, start] = v{2}{:};
  other = changed (strrep (v{1}, " ", "_"), before, v{3});
  if (isfield (other.par, "ke") && full.par.ke == 0)
    other = gsmbp_set (other, "ke", 0);
  endif
  a = gsmbp_simulate (full, start, t, "input", voltage, accuracy{:});
  b = gsmbp_simulate (other, start(v{4}), t, "input", v{5}, accuracy{:});
  printf ("%-12s %26.4f %14.2f\n", v{1}, 1e3 * max (abs (a.x(:,1) - b.x(:,1))), ...
          1e3 * seconds_of (other, start(v{4}), 1, "input", v{5}, accuracy{:}));
endfor
puts ("\n");

## --------------------------------------------------------------- control
## the motor follows n times the plan of the joint; or the motor angle that the inverse model gives,
## with the voltage that it asks for beside the controller's. The inverse model knows friction and
## twist, but not the kinematic error
ends = (0:0.001:1.5)';
q = gsmbp_evaluate (wide, ends)';
cases = {"plan alone", reference(wide, n); "inverse model", ...
         gsmbp_plan("table", points, [known.x(:,3:4), known.v], 3)};
## at the start the arm is held: by the integral part, or by the voltage beside the controller's
held = {x0(5) * 0.318, 0};
printf ("%-12s %-16s %22s %16s %14s\n", "controller", "reference", "largest error [mrad]", ...
        "at 1.5 s [mrad]", "ms for 1 s");
kinds = {"continuous", "sampled"};
for k = 1:2
  for c = 1:2
    run = controlled (kinds{k}, model, x0, begin, held{c}, cases{c,2}, accuracy);
    y = gsmbp_simulate (run{1:2}, ends, run{3:end}, "audit", 50);
    away{k,c} = 1e3 * (y.x(:,1) - q);
    current{k,c} = y.x(:,5);
    printf ("%-12s %-16s %22.2f %16.3f %14.2f\n", kinds{k}, cases{c,1}, max (abs (away{k, ...
            c})), away{k,c}(end), ...
            1e3 * seconds_of (run{1:2}, 1.5, run{3:end}));
    defect(k,c) = y.audit.error;
  endfor
endfor
printf ("continuous and sampled controller are %.1e rad apart at most\n", ...
        1e-3 * max (abs (away{1,1} - away{2,1})));
gsmbp_plot ("out/control.png", ends, panel ([away{2,1}, away{2,2}], ...
    {"plan alone", "inverse model"}, "error of the joint [mrad]"), ...
            panel ([current{2,2}, current{1,2}], {"sampled", "continuous"}, ...
                   "current [A]"), "title", "Cascade over the encoder of the motor");
printf ("energy audits of these runs: not found %.1e of what passed, at most\n", max (defect(:)));

## --------------------------------------------------------- slow reversals
slow = gsmbp_plan ("septic", [0 0.1 0 0.1], [0 2 4 6]);
ends = (0:0.01:6)';
run = controlled ("sampled", model, x0, begin, held{1}, reference (slow, n), accuracy);
y = gsmbp_simulate (run{1:2}, ends, run{3:end});
w = gsmbp_evaluate (slow, ends, 1);
gsmbp_plot ("out/reversal.png", ends, panel ([y.x(:,1), w(1,:,1)'], {"joint", "plan"}, ...
    "angle [rad]"), panel ([y.x(:,2), w(1,:,2)'], {"joint", "plan"}, "speed [rad/s]"), ...
            panel (y.v(:,6), {"controller"}, ...
                   "voltage [V]"), "title", "Slow reversals: friction, encoder, integral part");
printf ("\nslow reversals (0.1 rad in 2 s): %.2f mrad from the plan at most\n\n", ...
        1e3 * max (abs (y.x(:,1) - w(1,:,1)')));

at = gsmbp_inverse (m, plan, 0.5, "internal", [begin; 0; 0]);
gsmbp_timing (m, 0.5, at.x', "input", at.v, "qj", at.qj);
diary off

gsmbp_animate (m, f, "out/skeleton.png", "times", [0 0.5 1], "trace", "hand", "title", ...
               "Robot joint");
gsmbp_animate (m, f, "out/motion.gif", "times", 0:0.02:1, "trace", "hand", "title", "Robot joint");
