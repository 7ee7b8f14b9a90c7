## A double-acting plunger pump driven by an induction motor: start on the mains, steady running,
## torque against speed, reduced variants of the motor, the voltages and frequencies that an
## inverter needs for a planned motion; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## outputs at the rows of a run
function y = outputs (m, r)
  y = cell2mat (arrayfun (@(k) m.out (r.t(k), r.x(k,:)', r.v(k,:)'), 1:numel (r.t), ...
                          "UniformOutput", false))';
endfunction

## a run again and again: the last one, and the shortest computing time [s]
function [r, seconds] = timed (varargin)
  seconds = Inf;
  for k = 1:9
    r = gsmbp_simulate (varargin{:});
    seconds = min (seconds, r.stats.seconds);
  endfor
endfunction

## the scene with another variant of its motor, derived and compiled in out/
function m = reduced (variant)
  name = ["pump_" variant];
  text = strrep (fileread ("slider_crank_induction.mac"), "slider_crank_induction\"", [name "\""]);
  file = fullfile ("out", [name ".mac"]);
  fid = fopen (file, "w");
  fputs (fid, strrep (text, "ratio = n)", ["ratio = n, variant = " variant ")"]));
  fclose (fid);
  gsmbp_derive (file, fullfile ("out", "variants"));
  m = gsmbp_build (name, "directory", fullfile ("out", "variants"));
endfunction

## balance of energy over a run on constant inputs: Gauss' rule with five points in each of N pieces
function audit (m, x0, t_end, n, input, varargin)
  b = (1:4) ./ sqrt (4 * (1:4) .^ 2 - 1);
  [V, D] = eig (diag (b, 1) + diag (b, -1));
  h = t_end / n;
  t = [0; ((0:n-1) + (1 + diag (D)) / 2)(:) * h; t_end];
  [r, seconds] = timed (m, x0, t, "input", input, varargin{:});
  e = cell2mat (arrayfun (@(k) m.ene (t(k), r.x(k,:)', input)(:), 1:numel (t), "UniformOutput", ...
                          false));
  gone = @(p) h * sum (repmat (V(1,:) .^ 2, 1, n) .* p(2:end-1));
  E = sum (e(1:3,[1 end]));
  printf (["energy over %g s: in %.3f J, lost %.3f J, stored %.3f J, left over %.1e of what " ...
           "went in;\n  %d outputs, %.2f ms of computing for 1 s\n"], t_end, gone (e(4, ...
        :)), gone (e(5,:)), ...
          diff (E), abs (diff (E) - gone (e(4,:)) + gone (e(5,:))) / gone (e(4, ...
                :)), numel (t), 1e3 * seconds / t_end);
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("slider_crank_induction");
puts ("\n");
p = m.par;

## -------------------------------------- on the mains: 220 V, 60 Hz, at rest
mains = [220 * sqrt(2/3); 0; 377];   # amplitude of a phase; the frame turns with the supply
t = (0:0.001:1.5)';
r = gsmbp_simulate (m, m.initial, t, "input", mains);
y = outputs (m, r);
speed = r.x(:,4);
current = hypot (y(:,2), y(:,3));
gsmbp_csv ("out/start.csv", {"t", "speed", "torque", "current"}, [t, speed, y(:,1), current]);
gsmbp_plot ("out/start.png", t, panel (speed, {"crank"}, "speed [rad/s]"), panel (y(:,1), ...
    {"motor"}, "torque [N m]"), ...
            panel (current, {"phase, amplitude"}, "current [A]"), "title", "Start on the mains");
late = t >= 1;
puts ("on the mains\n");
printf (["  largest torque %.1f N m, least %.1f N m, largest current %.1f A; 95 %% of the " ...
         "speed after %.3f s\n"], max (y(:, ...
      1)), min (y(:,1)), max (current), ...
        t(find (speed > 0.95 * mean (speed(late)), 1)));
printf (["  after 1 s: crank %.3f to %.3f rad/s, slip %.2f to %.2f %%, torque %.2f to %.2f N " ...
         "m, current %.2f to %.2f A\n"], min (speed(late)), max (speed(late)), ...
        100 * (1 - [max(speed(late)), min(speed(late))] * p.n * p.motor_np / 377), min (y(late, ...
              1)), max (y(late,1)), min (current(late)), max (current(late)));
printf ("  ");
audit (m, m.initial, 1.5, 300, mains, "rtol", 1e-8);

## torque against speed: the run around the curve of constant speeds
up = t <= 0.6;
w = p.n * speed(up);
slip = 377 - p.motor_np * w;
Ls = p.motor_Lls + p.motor_Lm;
Lr = p.motor_Llr + p.motor_Lm;
leak = Ls * Lr - p.motor_Lm^2;
steady = 1.5 * p.motor_np * p.motor_Lm^2 * p.motor_Rr * slip ...
    * mains(1)^2 ./ ((p.motor_Rs * p.motor_Rr - 377 * slip * leak).^2 ...
                       + (p.motor_Rs * slip * Lr + 377 * Ls * p.motor_Rr).^2);
gsmbp_plot ("out/torque_speed.png", w, ...
            panel ([y(up,1), steady], {"start", "constant speed"}, "torque [N m]"), "xlabel", ...
            "speed of the motor [rad/s]", "head", "speed", "title", "Torque against speed");

## ------------------------------------------------------ reduced variants
puts ("\nreduced variants of the motor: start on the mains over 1.5 s, tolerance 1e-8\n");
printf ("%-10s %8s %12s %30s %22s %16s\n", "variant", "calls", "ms for 1 s", ...
        "largest error of crank speed", "after 1 s: mean speed", "and its swing");
words = {"full", "no_stator", "curve"};
speeds = speed;
for k = 1:3
  if (k == 1)
    other = m;
  else
    other = reduced (words{k});
  endif
  speeds(:,k) = gsmbp_simulate (other, other.initial, t, "input", mains).x(:,4);
  [run, seconds] = timed (other, other.initial, [0 1.5], "input", mains, "rtol", 1e-8);
  w = speeds(late,k);
  printf ("%-10s %8d %12.2f %24.2f rad/s %16.3f rad/s %10.3f rad/s\n", words{k}, ...
          run.stats.calls, 1e3 * seconds / 1.5, max (abs (speeds(:,k) - speed)), mean (w), ...
          max (w) - min (w));
endfor
gsmbp_plot ("out/variants.png", t, panel (speeds, words, "crank speed [rad/s]"), ...
            panel (speeds(:,2:3) - speed, words(2:3), "error of speed [rad/s]"), "title", ...
            "Reduced variants of the motor");

## --------------------------------------------- on an inverter: a planned motion
## 25 rad/s in 1 s, the acceleration rising and falling smoothly, then constant; the motor is
## magnetised before
plan = gsmbp_plan ("profile", mkpp ([0 1 2], [750 -1500 750 0 0; 0 0 0 0 0]), 2);
t = (0:0.005:2)';
inverse = gsmbp_inverse (m, plan, t);
gsmbp_csv ("out/inverse_dynamics.csv", {"t", "speed", "torque", "vd", "vq", "wk"}, ...
           [t, inverse.u(:,1), inverse.tau(:,1) / p.n, inverse.v]);
gsmbp_plot ("out/inverter.png", t, panel (inverse.u(:,1), {"crank, planned"}, ...
    "speed [rad/s]"), panel (inverse.v(:,1:2), {"vd", "vq"}, "voltage [V]"), ...
            panel (inverse.v(:,3) / (2 * pi), {"inverter"}, ...
                   "frequency [Hz]"), "title", "What the inverter must give");
puts ("\non an inverter: crank to 25 rad/s in 1 s, field orientation with 0.47 Wb\n");
printf ("  voltage up to %.1f V (mains: %.1f V), frequency up to %.1f Hz\n", ...
        max (hypot (inverse.v(:,1), inverse.v(:,2))), mains(1), ...
        max (inverse.v(:,3)) / (2 * pi));
printf ("  open loop on these inputs:\n%18s %26s %14s\n", "tolerance", "deviation of speed", ...
        "ms for 1 s");
for tolerance = 10 .^ -(6:2:12)
  [back, seconds] = timed (m, inverse.x(1,:)', 0:0.1:2, "motion", plan, "rtol", tolerance);
  printf ("%18.0e %20.1e rad/s %14.2f\n", tolerance, ...
          max (abs (back.x(:,4) - inverse.u(1:20:end,1))), 1e3 * seconds / 2);
endfor

## ------------------------------------------------------ what it costs
puts ("\n");
gsmbp_timing (m, 1, r.x(1001,:), "input", mains, "qj", inverse.qj(:,:,201));
puts ("\n");
gsmbp_workprecision (m, m.initial, [0 0.25 0.5], "input", mains, "rk4", [2e-3 1e-3 5e-4 1e-4], ...
                     "dp853", 10 .^ -(4:2:12), "file", "out/speed_error.png", "seconds", 0.05);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, inverse, "out/skeleton.png", "times", [0 0.5 0.6], "title", "Plunger pump");
