## A welding arm from its URDF: inverse kinematics of two seams, voltages of the motors against
## their supply, and the task under control; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

function t = joints (before)
  t = arrayfun (@(k) sprintf ("%s%d", before, k), 1:6, "UniformOutput", false);
endfunction

## angle between the axes R and S, pages of matrices [rad]
function a = angle_between (R, S)
  for k = 1:size (R, 3)
    D = R(:,:,k) - S(:,:,k);
    a(k) = 2 * asin (min (1, norm (D, "fro") / sqrt (8)));
  endfor
endfunction

## first time and coordinate of each margin that is not kept
function show_violations (speed, volts, list)
  text = "all margins kept";
  if (! isempty (list))
    text = strjoin (arrayfun (@(v) sprintf ("%s from t = %.2f s", strtok (v.text, ":"), v.time), ...
                              list(:)', "UniformOutput", false), ", ");
  endif
  printf ("%8.2f  %s   %s\n", speed, sprintf ("%7.1f", volts), text);
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("welding_arm");
supply = m.par.us;
limits = [cat(1, m.json.limits.low), cat(1, m.json.limits.high)];
unlimited = gsmbp_set (m, "us", 1e4);   # what would be needed, whatever the supply is

## ----------------------------------------------- from the seams to the joints
p = welding_plan (m, 0.35);
names = {"straight seam", "round the tube"};
puts ("\ninverse kinematics: the plan, put into the transformations of the URDF\n");
printf ("%-16s %6s %8s %12s %10s %14s %14s %20s\n", "", "poses", "branch", "length [m]", ...
        "turn [rad]", "place [m]", "axes [rad]", "wrist |sin q5|");
for k = 1:2
  s = p.seams(k);
  on = p.t >= s.times(1) & p.t <= s.times(2);
  f = gsmbp_along (s.path, p.t(on) - s.times(1));
  [P, R] = welding_tip (p.q(on,:)');
  printf ("%-16s %6d %8s %12.4f %10.4f %14.1e %14.1e %20s\n", names{k}, sum (on), ...
          mat2str (unique (s.told.branch)), s.path.length, s.path.angle, ...
          max (norm (P - f.p, "columns")), max (angle_between (R, f.R)), ...
          sprintf ("%.2f to %.2f", min (abs (sin (p.q(on,5)))), max (abs (sin (p.q(on,5))))));
endfor
puts ("all solutions at the begin of the straight seam [degrees]\n");
printf ("%6s %9s %9s %9s %9s %9s %9s %8s\n", "", "q1", "q2", "q3", "q4", "q5", "q6", ...
        "within");
found = p.seams(1).told.solutions{1};
for k = 1:columns (found)
  inside = all (found(:,k) >= limits(:,1) & found(:,k) <= limits(:,2));
  printf ("%6d %9.2f %9.2f %9.2f %9.2f %9.2f %9.2f %8s\n", k, 180 / pi * found(:,k), ...
          {"no", "yes"}{1 + inside});
endfor

## ------------------------------------------- voltages against the supply
printf (["\nvoltages that the task needs, the straight seam at several speeds; " ...
         "the supply gives %g V\n"], supply);
printf ("%8s  %s   margins\n", "[m/s]", sprintf ("%7s", joints ("|v|"){:}));
for speed = [0.5, 0.4, 0.35]
  q = welding_plan (m, speed);
  times = q.t(2:2:end-1);
  r = gsmbp_inverse (unlimited, q.motion, times);
  if (speed == 0.5)
    fast = struct ("t", times', "y", r.y, "seam", q.seams(1).times);
  endif
  show_violations (speed, max (abs (r.y)), gsmbp_inverse (m, q.motion, times).violations);
endfor
slow = r;
gsmbp_csv ("out/plan.csv", [{"t"}, joints("q"), joints("tau"), joints("v")], ...
           [slow.t, slow.q, slow.tau, slow.y]);
gsmbp_plot ("out/joints.png", slow.t, panel (slow.q, joints ("q"), "joint angle [rad]"), ...
            panel (slow.u, joints ("q"), "joint speed [rad/s]"), "title", ...
            "Welding arm: joints along the task");
line = @(t) supply * ones (size (t));
on = fast.t >= fast.seam(1) & fast.t <= fast.seam(2);
t = fast.t(on) - fast.seam(1);
gsmbp_plot ("out/voltage_fast.png", t, ...
            panel ([abs(fast.y(on,[1 2 4])), line(t)], ...
                   {"motor 1", "motor 2", "motor 4", "supply"}, "modulus of the voltage [V]"), ...
            "xlabel", "time on the seam [s]", "size", [16 8], "title", "Straight seam at 0.5 m/s");
gsmbp_plot ("out/voltages.png", slow.t, ...
            panel ([abs(slow.y(:,1:3)), line(slow.t)], ...
                   {"motor 1", "motor 2", "motor 3", "supply"}, "modulus of the voltage [V]"), ...
            panel ([abs(slow.y(:,4:6)), line(slow.t)], ...
                   {"motor 4", "motor 5", "motor 6", "supply"}, "modulus of the voltage [V]"), ...
            "title", ...
            "Voltages of the task, straight seam at 0.35 m/s");

## ------------------------------------------------------ open loop, energy
warning ("off", "gsmbp:stiff");   # dry friction of joints at rest
x0 = gsmbp_inverse (m, p.motion, 0).x';
t = (0:0.005:p.t(end) - 0.005)';
wanted = welding_tip (p.q(1:numel (t),:)');
away = @(r) 1e3 * norm (welding_tip (r.x(:,1:6)') - wanted, "columns")';
r = gsmbp_simulate (m, x0, t, "motion", p.motion, "audit", 100);
printf (["\nopen loop, the voltages computed at every call: the wire is %.1e mm from the plan " ...
         "at most; energy not found: %.1e of the %.0f J that passed\n"], max (away (r)), ...
        r.audit.error, r.audit.passed(end));

## ------------------------------------------------------ under control
## the inverse model's commands as a table of 5 ms, on top of them 8 V for a degree and 8 V s/rad
planned = gsmbp_inverse (m, p.motion, t);
feed = gsmbp_plan ("table", t, planned.v, 3);
reference = gsmbp_plan ("table", t, planned.x, 3);
K = [460 * eye(6), 8 * eye(6), zeros(6)];
loops = {"commands alone", {}; "with feedback", {"gain", K, "reference", reference}};
cases = {"as planned", m, 0; "feeder heavier by 2 kg", gsmbp_set(m, "mf", m.par.mf + 2), 0
         "supply of 20 V", gsmbp_set(m, "us", 20), 0; "start 5 mrad beside", m, 0.005};
puts ("\nsimulation (DOP853): distance of the wire from its plan [mm]\n");
printf ("%-24s %-16s %10s %16s %16s %12s %12s\n", "", "motors", "largest", names{:}, ...
        "at the end", "max |v| [V]");
for i = 1:rows (cases)
  for j = 1:2
    start = x0 + [cases{i,3} * ones(6, 1); zeros(12, 1)];
    run = gsmbp_simulate (cases{i,2}, start, t, "input", feed, "rtol", 1e-8, loops{j,2}{:});
    e{i,j} = away (run);
    on = @(k) t >= p.seams(k).times(1) & t <= p.seams(k).times(2);
    printf ("%-24s %-16s %10.3f %16.3f %16.3f %12.3f %12.2f\n", cases{i,1}, loops{j,1}, ...
            max (e{i,j}), max (e{i,j}(on (1))), max (e{i,j}(on (2))), e{i,j}(end), ...
            max (abs (run.y(:))));
    if (i == 2 && j == 2)
      followed = run;
    endif
  endfor
endfor
gsmbp_csv ("out/control.csv", {"t", "planned", "heavier", "weak", "beside"}, [t, e{:,2}]);
gsmbp_plot ("out/control.png", t, panel (e{2,2}, cases(2,1), "off the plan [mm]"), ...
            panel (e{3,2}, cases(3,1), "off the plan [mm]"), "title", ...
            "Welding arm under feedback: the wire off its plan");
puts ("\n");
gsmbp_timing (m, 2, x0', "input", planned.v(1,:));
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, followed, "out/skeleton.png", "times", mean (cell2mat ({p.seams.times}')'), ...
               "trace", "wire", "centres", false, "title", "Welding arm on its two seams");
gsmbp_animate (m, followed, "out/motion.gif", "times", 0:0.08:t(end), "fps", 12.5, "trace", ...
               "wire", "centres", false, "title", "Welding arm", "width", 440);
