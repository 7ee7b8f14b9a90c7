## A SCARA robot puts a part from a pick to a place: both elbows, the quickest motion within limits
## and the least time along an arch that the voltages allow, and both under control; everything goes
## into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

function t = motors (before)
  t = arrayfun (@(k) sprintf ("%s%d", before, k), 1:4, "UniformOutput", false);
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("scara");
supply = 24;
limits = [cat(1, m.json.limits.low), cat(1, m.json.limits.high)];
names = {"left elbow", "right elbow"};

## ------------------------------------------------------------- both elbows
puts ("\nthe gate on both branches of the inverse kinematics\n");
printf ("%-12s %36s %36s %10s %10s\n", "", "q at the pick [degrees, mm]", ...
        "q at the place [degrees, mm]", "within", "time [s]");
scale = [180/pi; 180/pi; 1000; 180/pi];
for k = 1:2
  [path{k}, q{k}] = scara_gate (m, k);
  [motion{k}, laws] = scara_cycle (q{k});
  inside = all (all (q{k} >= limits(:,1) & q{k} <= limits(:,2)));
  printf ("%-12s %36s %36s %10s %10.4f\n", names{k}, sprintf ("%9.2f", scale .* q{k}(:,1)), ...
          sprintf ("%9.2f", scale .* q{k}(:,4)), {"no", "yes"}{1 + inside}, ...
          motion{k}.breaks(end-1));
endfor
[place, angle] = scara_hand (m.par, q{1});
corners = [0.36 0.36 0.05 0.05; -0.22 -0.22 0.44 0.44; 0.08 0.16 0.16 0.08];
printf ("the corners put into x = l1 cos q1 + l2 cos(q1 + q2), ...: %.0e m, %.0e rad off\n", ...
        max (max (abs (place - corners))), max (abs (angle - [0 0 pi/2 pi/2])));

## -------------------------------------------------- double S: what it needs
puts (["\ndouble S from corner to corner, with the part: largest voltages, and the " ...
       "differences from formulas by hand\n"]);
printf ("%-12s %8s %8s %8s %8s %22s %22s\n", "", "|v1| [V]", "|v2|", "|v3|", "|v4|", ...
        "efforts by hand [N m]", "v without L [V]");
for k = 1:2
  t = linspace (0, motion{k}.breaks(end), 801)(1:end-1);
  needed{k} = gsmbp_inverse (m, motion{k}, t);
  still = gsmbp_inverse (m, motion{k}, t, "quasistatic", true);
  r = needed{k};
  [~, ~, tau, v] = scara_hand (m.par, r.q', r.u', r.ud');
  printf ("%-12s %8.2f %8.2f %8.2f %8.2f %22.0e %22.0e\n", names{k}, max (abs (r.v)), ...
          max (max (abs (tau' - r.tau))), max (max (abs (v' - still.v))));
endfor
[~, best] = min (cellfun (@(p) p.breaks(end), motion));
printf ("the quicker one: %s\n", names{best});

## --------------------------------------------- least time along the arch
effort = [150, 90, 500, 4];
[quick, told] = gsmbp_retime (m, path{best}, "input", supply - 1, "effort", effort, ...
                              "rtol", 1e-4, "points", 100);
t = linspace (0, told.T, 601)(2:end-1);
r = gsmbp_inverse (m, quick, t, "quasistatic", true);
f = gsmbp_evaluate (quick, t, 2);
[P, ~, tau, v] = scara_hand (m.par, f(:,:,1), f(:,:,2), f(:,:,3));
printf (["\nleast time along the arch for %g V and efforts of %g, %g N m, %g N, %g N m: " ...
         "%.4f s, the double S needs %.4f s\n"], supply - 1, effort, told.T, ...
        motion{best}.breaks(end-1));
printf ("%-6s %14s %14s %16s %16s\n", "", "largest |v| [V]", "|effort|", "|v| by hand [V]", ...
        "at a limit [%]");
full = max (abs (r.v) / (supply - 1), abs (r.tau) ./ effort) > 0.97;
for k = 1:4
  printf ("%-6s %14.2f %14.2f %16.2f %16.0f\n", sprintf ("M%d", k), max (abs (r.v(:,k))), ...
          max (abs (r.tau(:,k))), max (abs (v(k,:))), 100 * mean (full(:,k)));
endfor
printf ("one of them at its limit during %.0f %% of the time\n", 100 * mean (any (full, 2)));
gsmbp_csv ("out/least_time.csv", [{"t"}, motors("q"), motors("tau"), motors("v")], ...
           [r.t, r.q, r.tau, r.v]);
slow = needed{best};
gsmbp_csv ("out/double_s.csv", [{"t"}, motors("q"), motors("tau"), motors("v")], ...
           [slow.t, slow.q, slow.tau, slow.v]);
joint = {"upper arm", "forearm", "quill", "hand"};
gsmbp_plot ("out/double_s.png", slow.t, ...
            panel (slow.u(:,[1 2 4]), joint([1 2 4]), "speed [rad/s]"), ...
            panel (slow.u(:,3), joint(3), "speed of the quill [m/s]"), ...
            panel (slow.v, joint, "voltage [V]"), "title", "Double S from corner to corner");
gsmbp_plot ("out/least_time.png", r.t, panel (r.u(:,[1 2 4]), joint([1 2 4]), "speed [rad/s]"), ...
            panel (r.u(:,3), joint(3), "speed of the quill [m/s]"), ...
            panel (r.v, joint, "voltage [V]"), "title", "Least time along the arch");

## ------------------------------------------------------ under control
warning ("off", "gsmbp:stiff");
place = [0.05; 0.44; 0.08];
K = [diag([400, 400, 4000, 100]), diag([6, 6, 60, 2]), zeros(4)];
heavy = gsmbp_set (m, "mp", 2 * m.par.mp);
## the least time ends with a rest of 0.2 s, too
plans = {"double S", scara_held(motion{best}, 0.1), false
         "least time", scara_held(quick, 0.2), true};
models = {"as planned", m; "part twice as heavy", heavy};
puts ("\nsimulation (DOP853), voltages of the plan and feedback, within 24 V: the tool\n");
printf ("%-12s %-22s %18s %28s %22s %14s\n", "plan", "", "off the plan [mm]", ...
        "off the place at the end [mm]", "within 0.1 mm at [s]", "max |v| [V]");
for i = 1:2
  p = plans{i,2};
  t = (0:5e-4:p.breaks(end))';
  r = gsmbp_inverse (m, p, t, "quasistatic", plans{i,3});
  f = gsmbp_evaluate (p, t, 2);
  x = [f(:,:,1)', f(:,:,2)', r.tau ./ [50 * 0.07, 40 * 0.07, 2 * pi / 0.016 * 0.06, 20 * 0.06]];
  wanted = scara_hand (m.par, f(:,:,1));
  for j = 1:2
    run = gsmbp_simulate (models{j,2}, x(1,:)', t, "input", gsmbp_plan ("table", t, r.v, 1), ...
                          "gain", K, "reference", gsmbp_plan ("table", t, x, 1), ...
                          "limits", supply, "rtol", 1e-8);
    at = scara_hand (m.par, run.x(:,1:4)');
    off{i,j} = 1e3 * norm (at - wanted, "columns")';
    from_place = 1e3 * norm (at - place, "columns");
    last = find (from_place > 0.1, 1, "last");
    arrived = "-";
    if (last < numel (t))
      arrived = sprintf ("%.4f", t(last+1));
    endif
    printf ("%-12s %-22s %18.3f %28.4f %22s %14.2f\n", plans{i,1}, models{j,1}, ...
            max (off{i,j}), from_place(end), arrived, max (abs (run.v(:))));
    runs{i,j} = run;
  endfor
  times{i} = t;
endfor
gsmbp_csv ("out/control.csv", {"t", "planned", "heavy"}, [times{2}, off{2,:}]);
gsmbp_plot ("out/control.png", times{2}, ...
            panel ([off{2,:}], models(:,1)', "off the plan [mm]"), ...
            panel (runs{2,1}.v, joint, "voltage [V]"), "title", ...
            "Least time along the arch under feedback");

## open loop, energy
r = gsmbp_simulate (m, needed{best}.x(1,:)', times{1}(1:end-1), "motion", motion{best}, ...
                    "audit", 10);
printf (["\nopen loop, the voltages computed at every call: %.1e mm from the plan at most; " ...
         "energy not found: %.1e of the %.1f J that passed\n\n"], ...
        1e3 * max (norm (scara_hand (m.par, r.x(:,1:4)') - scara_hand (m.par, ...
            gsmbp_evaluate (motion{best}, r.t)), "columns")), r.audit.error, r.audit.passed(end));
gsmbp_timing (m, 0.1, needed{best}.x(200,:)', "input", needed{best}.v(200,:));
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, runs{2,1}, "out/skeleton.png", "times", linspace (0, told.T, 4), "trace", ...
               "tool", "centres", false, "title", "SCARA robot along its arch");
gsmbp_animate (m, runs{2,1}, "out/motion.gif", "times", 0:0.01:told.T + 0.1, "speed", 0.25, ...
               "fps", 25, "trace", "tool", "centres", false, "title", ...
               "SCARA robot, four times slower", "width", 440);
