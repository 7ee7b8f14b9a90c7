## Andrews' squeezing mechanism over its 0.03 s: against the published solution and a reference of 27 digits, by six ways; everything goes into out/.

warning ("off", "Octave:shadowed-function");   # this file has the name of a function of Octave

addpath (fullfile (fileparts (mfilename ("fullpath")), ".."));   # open_report, panel, film
open_report (mfilename ("fullpath"));

## ---------------------------------------------------------------- the model
[cpu, wall] = gsmbp_derive ("andrews.mac");
printf ("derivation: %.1f s of processor time, %.1f s by the clock, Maxima's start included\n", cpu, wall);
m = gsmbp_build ("andrews");

## ------------------------------------------- where it starts: the loops close
published = [-0.0617138900142764496358948458001, 0, 0.455279819163070380255912382449, 0.487364979543842550225598953530, 0.222668390165885884674473185609, ...
             1.23054744454982119249735015568, -0.222668390165885884674473185609]';
x0 = gsmbp_assemble (m, [published(1); round(10 * published(2:7)) / 10], "hold", "beta");
printf ("loops closed from angles of one decimal, the crank at its published angle: %.1e rad from the published start\n", max (abs (x0(1:7) - published)));
gsmbp_mobility (m, x0);
[ud, lam] = m.acc (0, x0);
printf ("first accelerations of crank and K2 [rad/s^2]: %.9f, %.9f (published 14222.443919954, -10666.832939966), of the others below %.0e\n", ud(1:2), max (abs (ud(3:7))));
printf ("first forces in pin E of K3 [N]: %.9f, %.9f (published 98.566870396, -6.122688344)\n\n", lam(1:2));

## ------------------------------------------------------------- the motion
table = dlmread (fullfile ("..", "..", "tests", "data", "04_andrews_squeezer", "reference.csv"), ",", 1, 0);
t = table(:,1);
angles = table(:,2:8);
speeds = table(:,9:15);
puts ("0.03 s by the six ways (DOP853; absolute tolerance of the speeds 1000 times that of the angles); reference: 27 digits, every 1 ms\n");
printf ("%-14s %8s %14s %14s %14s %12s %14s %14s %10s %10s\n", "way", "rtol", "angles [rad]", "at 0.03 s", "speeds [rad/s]", "|phi| [m]", "|phidot| [m/s]", "energy [J/J]", "calls", "ms");
for rtol = [1e-7 1e-10 1e-13]
  for way = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"}
    best = Inf;
    for k = 1:6
      run = gsmbp_simulate (m, x0, t, "loops", way{1}, "rtol", rtol, "atol", rtol * [ones(7, 1); 1e3 * ones(7, 1)]);
      best = min (best, run.stats.seconds);
    endfor
    e = cell2mat (arrayfun (@(k) m.ene (t(k), run.x(k,:)'), 1:numel (t), "UniformOutput", false));
    supplied = m.par.mom * (run.x(:,1)' - x0(1));
    s = run.stats;
    printf ("%-14s %8.0e %14.1e %14.1e %14.1e %12.1e %14.1e %14.1e %10d %10.2f\n", way{1}, rtol, max (max (abs (run.x(:,1:7) - angles))), max (abs (run.x(end,1:7) - angles(end,:))), ...
            max (max (abs (run.x(:,8:14) - speeds))), s.drift.phi, s.drift.phidot, max (abs (sum (e(1:3,:)) - sum (e(1:3,1)) - supplied)) / max (e(1,:)), s.calls, 1e3 * best);
  endfor
endfor
puts ("(largest values; energy: kinetic and potential less the work of the drive, over the largest kinetic; speeds reach 1425 rad/s)\n\n");

names = {"beta", "theta", "gamma", "phi", "delta", "Omega", "epsilon"};
final = [15.81077119629904, -15.75637105984298, 0.04082224013073101, -0.5347301163226948, 0.5244099658805304, 0.5347301163226948, 1.048080741042263];
run = gsmbp_simulate (m, x0, t, "rtol", 1e-13, "atol", 1e-13 * [ones(7, 1); 1e3 * ones(7, 1)]);
puts ("angles at 0.03 s [rad]\n");
printf ("%-10s %22s %22s %22s\n", "", "GSMBP", "27 digits, rounded", "published (IVP set)");
for k = 1:7
  i = find (strcmp (m.coordinates, names{k}));
  printf ("%-10s %22.14f %22.14f %22.14f\n", names{k}, run.x(end,i), angles(end,i), final(k));
endfor
puts ("\n");

## ---------------------------------------------------------------- figures
fine = gsmbp_simulate (m, x0, linspace (0, 0.03, 1501));
f = cell2mat (arrayfun (@(k) m.out (fine.t(k), fine.x(k,:)'), 1:numel (fine.t), "UniformOutput", false))';
e = cell2mat (arrayfun (@(k) m.ene (fine.t(k), fine.x(k,:)'), 1:numel (fine.t), "UniformOutput", false))';
gsmbp_plot ("out/angles.png", 1e3 * fine.t, panel (fine.x(:,1:2), {"beta (crank)", "theta"}, "angle [rad]"), panel (fine.x(:,3:7), {"gamma", "delta", "phi", "epsilon", "Omega"}, "angle [rad]"), ...
            "xlabel", "time [ms]", "head", "ms", "title", "Andrews' squeezer: the seven angles");
pins = hypot (f(:,1:2:5), f(:,2:2:6));
gsmbp_plot ("out/forces.png", 1e3 * fine.t, panel (pins, {"K2 on K3", "K2 on K4", "K2 on K6"}, "force in pin E [N]"), panel ([e(:,1), e(:,2), m.par.mom * (fine.x(:,1) - x0(1))], ...
            {"kinetic", "spring", "work of drive"}, "energy [J]"), "xlabel", "time [ms]", "head", "ms", "title", "Andrews' squeezer: forces and energy");
printf ("largest forces in pin E: %.1f N on K3, %.1f N on K4, %.1f N on K6\n\n", max (pins));

## ------------------------------------------------------ what it costs
gsmbp_timing (m, 0.02, table(t == 0.02, 2:15)');
puts ("\n");
gsmbp_workprecision (m, x0, [0 0.015 0.03], "rk4", [4e-5 2e-5 1e-5 5e-6], "dp853", 10 .^ -(6:13), "file", "out/speed_error.png", "seconds", 0.05);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, fine, "out/skeleton.png", "times", [0 0.011 0.0145], "title", "Andrews' squeezer");
gsmbp_animate (m, fine, "out/motion.gif", "times", 0.004:2e-4:0.022, "fps", 15, "title", "Andrews' squeezer, 333 times slower", "width", 560);
