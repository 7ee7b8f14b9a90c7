## The slider-crank of Ju and Hsu (1991): a DC motor drives the crank from rest to 4 rad/s.
## Figures 7 to 9 of the paper, their numbers, and what the program itself costs; everything goes
## into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

function row (format, values)
  printf (format, values'(:));
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("slider_crank");
puts ("\n");

## the crank's acceleration: up linearly to 4 rad/s^2 in 1 s, down to zero at 2 s, then constant
## speed
plan = gsmbp_plan ("profile", mkpp ([0 1 2 6], [4 0; -4 4; 0 0]), 2);
t = (0:0.01:6)';

## --------------------------------------- inverse dynamics: figures 7 and 8
## v needs the whole model; tau is the torque that the linkage alone takes, so rotor inertia and
## motor friction are out of it
linkage = gsmbp_set (m, "jm", 0, "bm", 0);
r = gsmbp_inverse (m, plan, t);
tau = gsmbp_inverse (linkage, plan, t).tau;
omega_crank = r.u(:,1);
omega_rod = r.u(:,1) + r.u(:,2);   # q2 is measured from the crank
gsmbp_csv ("out/inverse_dynamics.csv", {"t", "omega_crank", "omega_rod", "tau", "v"}, ...
           [t, omega_crank, omega_rod, tau, r.v]);

speed = struct ("y", [omega_crank, omega_rod], "names", {{"crank", "rod"}}, "label", ...
                "angular speed [rad/s]");
gsmbp_plot ("out/figure_07.png", t, speed, "title", "Desired angular speeds");
torque = struct ("y", tau, "names", {{"torque at crank"}}, "label", "torque [N m]");
voltage = struct ("y", r.v, "names", {{"motor voltage"}}, "label", "voltage [V]");
gsmbp_plot ("out/figure_08.png", t, torque, voltage, "title", ...
            "Torque and voltage along the motion");

puts ("inverse dynamics: torque of the linkage at the crank, voltage of the motor\n");
printf ("%8s %16s %16s %12s %10s\n", "t [s]", "crank [rad/s]", "rod [rad/s]", "tau [N m]", "v [V]");
before = gsmbp_inverse (m, plan, 1, "side", -1);
for at = [0.5 1 1.5 2.5 3 5]
  k = find (abs (t - at) < 1e-9);
  if (at == 1)
    row ("%7.2f- %16.6f %16.6f %12.6f %10.4f\n", ...
         [at, omega_crank(k), omega_rod(k), tau(k), before.v]);
    row ("%7.2f+ %16.6f %16.6f %12.6f %10.4f\n", ...
         [at, omega_crank(k), omega_rod(k), tau(k), r.v(k)]);
  else
    row ("%8.2f %16.6f %16.6f %12.6f %10.4f\n", [at, omega_crank(k), omega_rod(k), tau(k), r.v(k)]);
  endif
endfor
late = t >= 3;
printf (["torque %.2f to %.2f N m, voltage %.1f to %.1f V, rod speed up to %.2f " "rad/s\n"], ...
        min (tau), max (tau), min (r.v), max (r.v), max (abs (omega_rod)));
printf (["voltage and torque are not proportional (correlation %.2f): after 3 s the torque " ...
         "swings from %.2f to %.2f N m, the voltage stays between %.1f and %.1f V\n\n"], ...
        corr (tau, r.v), min (tau(late)), max (tau(late)), min (r.v(late)), max (r.v(late)));

## ------------------------------------------------- open loop: figure 9
## the computed voltage drives the model; classical Runge-Kutta, 1 ms, once with Baumgarte's terms
## (the paper's way), once with projection
x0 = r.x(1,:)';
closure = @(x) cellfun (@(q) norm (m.con (0, q), Inf), num2cell (x(:,1:3)', 1)');
free = gsmbp_set (m, "baumgarte_alpha", 0, "baumgarte_beta", 0);
ways = {"nothing", free, false; "Baumgarte", m, false; "projection", m, true};
printf ("open loop over 6 s, RK4, 1 ms (Baumgarte: alpha = beta = %g/s)\n", m.par.baumgarte_alpha);
printf ("%-12s %14s %16s %22s %12s\n", "loop held by", "|phi| [m]", "|phidot| [m/s]", ...
        "crank speed [rad/s]", "ms for 1 s");
for k = 1:rows (ways)
  run{k} = gsmbp_simulate (ways{k,2}, x0, t, "motion", plan, "method", "rk4", "step", 1e-3, ...
                           "projection", ways{k,3});
  drift(:,k) = closure (run{k}.x);
  d = run{k}.stats.drift;
  printf ("%-12s %14.1e %16.1e %22.1e %12.2f\n", ways{k,1}, d.phi, d.phidot, ...
          max (abs (run{k}.x(:,4) - omega_crank)), 1e3 * run{k}.stats.seconds / 6);
endfor
puts ("(largest values; the crank speed is the deviation from the planned one)\n\n");
gsmbp_csv ("out/open_loop.csv", {"t", "omega_nominal", "omega", "drift"}, ...
           [t, omega_crank, run{2}.x(:,4), drift(:,2)]);

## the same voltage as a table, linear in between: what an amplifier fed by samples would do
puts (["voltage from a table, linear in between, instead of the computed one " ...
       "(DOP853, projection)\n"]);
printf ("%16s %32s\n", "points each [s]", "largest deviation [rad/s]");
for step = [0.5 0.2 0.1 0.05 0.02]
  points = (0:step:6)';
  table = gsmbp_plan ("table", points, gsmbp_inverse (m, plan, points).v, 1);
  sampled = gsmbp_simulate (m, x0, t, "input", table);
  tabled.(sprintf ("each%d", 1000 * step)) = sampled.x(:,4);
  printf ("%16.2f %32.2e\n", step, max (abs (sampled.x(:,4) - omega_crank)));
endfor
puts ("\n");

controlled = [run{2}.x(:,4), tabled.each500];
both = struct ("y", [omega_crank, controlled], "names", ...
               {{"nominal", "computed voltage", "voltage each 0.5 s"}}, "label", ...
               "crank speed [rad/s]");
deviation = struct ("y", 1e3 ...
    * ([run{2}.x(:,4), tabled.each500, tabled.each100] ...
         - omega_crank), "names", {{"computed voltage", "voltage each 0.5 s", ...
                                    "voltage each 0.1 s"}}, ...
                    "label", "deviation [mrad/s]");
gsmbp_plot ("out/figure_09.png", t, both, deviation, "title", ...
            "Crank speed in open loop, nominal and controlled");
left = struct ("y", max (drift, 1e-18), "names", ...
               {{"no stabilization", "Baumgarte", "projection"}}, "label", ...
               "gap of the loop [m]");
gsmbp_plot ("out/figure_09_drift.png", t, left, "title", "Drift of the closed loop: RK4, 1 ms", ...
            "scale", "semilogy");

## ------------------------------------------------------ what it costs
at = gsmbp_inverse (m, plan, 2.5);
gsmbp_timing (m, 2.5, at.x', "input", at.v, "qj", at.qj);
puts ("\n");
gsmbp_workprecision (m, x0, [0 1 2 6], "motion", plan, "rk4", [5e-3 2e-3 1e-3 5e-4 1e-4], ...
                     "dp853", 10 .^ -(4:2:12), "file", "out/speed_error.png", "seconds", 0.05);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, r, "out/skeleton.png", "times", [1 1.6 2], "trace", "rod", "title", ...
               "Slider-crank");
gsmbp_animate (m, r, "out/motion.gif", "times", 0:0.05:4, "trace", "rod", "title", "Slider-crank");
