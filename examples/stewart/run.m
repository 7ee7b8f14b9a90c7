## A Stewart-Gough platform on six driven legs: kinematics both ways beside closed formulas, the
## forces that a motion needs, the motion under computed force and under control; everything goes
## into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## forces along the legs, if these have no mass: Newton and Euler for the platform
function f = forces_by_hand (p, pose, rate, acc)
  [~, w, wd, R, ~, Rdd] = stewart_turning (pose, rate, acc);
  [~, ~, ~, n, top] = stewart_legs (p, pose, rate, acc);
  c = [0; 0; p.hp];
  J = diag ([p.jx, p.jx, p.jz]);
  pull = p.mp * (acc(1:3) + Rdd * c + [0; 0; p.g]);
  turn = R * (J * wd + cross (w, J * w));
  f = [n; cross(R * (top - c), n)] \ [pull; turn];
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("stewart");
x0 = m.initial;
gsmbp_mobility (m, x0);
strokes = arrayfun (@(k) sprintf ("s%d", k), 1:6, "UniformOutput", false);
leg = arrayfun (@(k) sprintf ("leg %d", k), 1:6, "UniformOutput", false);

## -------------------------------------- from platform to legs, and back
puts (["\nplatform to legs: the program's loops closed with the platform held, " ...
       "against the closed form\n"]);
printf ("%-46s %16s %40s\n", "x, y, z [m], roll, pitch, yaw [degrees]", "difference", ...
        "strokes [mm]");
for pose = [0 0 0.8 0 0 0; 0.1 0 0.8 0 0 0; 0 0 0.85 15 0 0; 0.05 -0.05 0.75 0 -12 20]'
  pose(4:6) *= pi / 180;
  e = stewart_turning (pose, zeros (6, 1), zeros (6, 1));
  x = gsmbp_assemble (m, [pose(1:3); e; x0(8:25)], "hold", {"x", "y", "z", "e0", "e1", "e2", "e3"});
  q = stewart_legs (m.par, pose, zeros (6, 1), zeros (6, 1));
  printf ("%-46s %16.1e %10.2f %7.2f %7.2f %7.2f %7.2f %7.2f\n", ...
          sprintf ("%5.2f ", pose(1:3), 180 / pi * pose(4:6)), max (abs (x(8:25) - q(:))), ...
          1e3 * q(3,:));
endfor
X = gsmbp_assemble (m, x0, "hold", strokes, "branches", 60);
X(4:7,:) .*= sign (X(4,:));
[~, own] = unique (round (1e6 * X(1:7,:)') + 0, "rows");
printf (["legs to platform: six strokes as at the start, 61 guesses: %d assemblies; " ...
         "the platform has %d places:\n"], columns (X), numel (own));
printf ("%10s %10s %10s %26s\n", "x [m]", "y [m]", "z [m]", "turned by [degrees]");
places = sortrows ([X(1:3,own)', 360 / pi * acos(min (X(4,own)', 1))], [-3, -1, -2]);
printf ("%10.4f %10.4f %10.4f %26.3f\n", (round (1e9 * places) / 1e9 + 0)');

## --------------------------------------------------------------- the motion
[t, x, force, f, ud, wrong] = stewart_plan (m);
nt = numel (t);
own = zeros (24, 6);
own(9:3:24,:) = eye (6);
light = gsmbp_set (m, "mc", 0, "jc", 0, "mr", 0, "jr", 0, "kc", 0);
for k = 1:nt
  [q, u] = deal (x(k,1:25)', x(k,26:49)');
  e = m.ene (t(k), x(k,:)', force(k,:)');
  power(k,:) = [sum(e(1:3)), u(9:3:24)' * force(k,:)'];
  [~, ~, H] = m.con (t(k), q, u);
  without = [own, H'] \ light.inv (t(k), q, u, ud(k,:)', zeros (6, 1));
  wrong(k,4) = max (abs (without(1:6) - forces_by_hand (m.par, f(:,k,1), f(:,k,2), f(:,k,3))));
endfor
printf (["\nthe motion: loops %.0e m; strokes' speeds and accelerations against the " ...
         "closed form %.0e m/s, %.0e m/s^2\n"], max (wrong(:,1:3)));
printf (["legs without mass and springs: forces against Newton and Euler for the " ...
         "platform alone %.0e N\n"], max (wrong(:,4)));
gain = cumtrapz (t, power(:,2));
printf ("work of the drives and change of energy: %.6f and %.6f J after 2 s\n", gain(t == 2), ...
        power(t == 2,1) - power(1,1));
printf (["strokes from %.1f to %.1f mm, speeds up to %.3f m/s; forces of the drives from %.1f " ...
         "to %.1f N (at rest %.2f N each)\n\n"], ...
        1e3 * min (min (x(:,10:3:25))), 1e3 * max (max (x(:,10:3:25))), max (max (abs (x(:, ...
                  34:3:49)))), min (force(:)), max (force(:)), force(1,1));
printf ("%8s %10s %10s %10s %10s %10s %10s\n", "t [s]", "f1 [N]", "f2", "f3", "f4", "f5", "f6");
for k = 1:200:nt
  printf ("%8.1f %10.4f %10.4f %10.4f %10.4f %10.4f %10.4f\n", t(k), force(k,:));
endfor
gsmbp_csv ("out/motion_plan.csv", ...
           [{"t", "x", "y", "z", "roll", "pitch"}, strokes, strrep(strokes, "s", "f")], ...
           [t, f(1:5,:,1)', x(:,10:3:25), force]);
gsmbp_plot ("out/legs.png", t, panel (1e3 * x(:,10:3:25), leg, "stroke [mm]"), ...
            panel (force, leg, "force of drive [N]"), "title", ...
            "Stewart platform: strokes and forces along the motion");

## ---------------------------------- under computed force, and under control
feed = gsmbp_plan ("table", t, force, 3);
reference = gsmbp_plan ("table", t, x, 3);
K = zeros (6, 49);
K(:,10:3:25) = 4e4 * eye (6);
K(:,34:3:49) = 800 * eye (6);
shifted = gsmbp_assemble (m, [x0(1:2) + [0.01; 0]; x0(3:end)], "hold", ...
                          {"x", "y", "z", "e0", "e1", "e2", "e3"});
heavy = gsmbp_set (m, "mp", 1.25 * m.par.mp, "jx", 1.25 * m.par.jx, "jz", 1.25 * m.par.jz);
cases = {"as planned", m, x0; "start 1 cm aside", m, shifted; "platform heavier by 25 %", heavy, ...
         x0};
loops = {"computed force", {}; "with feedback", {"gain", K, "reference", reference}};
puts ("\nsimulation (DOP853, 1e-10, projection): distance of the platform from its plan\n");
printf ("%-26s %-26s %16s %16s %18s\n", "", "drives", "largest [mm]", "at 6 s [mm]", ...
        "turned [mrad]");
for i = 1:rows (cases)
  for j = 1:2
    run = gsmbp_simulate (cases{i,2}, cases{i,3}, t, "input", feed, loops{j,2}{:});
    away{i,j} = 1e3 * sqrt (sum ((run.x(:,1:3) - f(1:3,:,1)') .^ 2, 2));
    turned = 2e3 * sqrt (max (0, 1 - min (1, abs (sum (run.x(:,4:7) .* x(:,4:7), 2))) .^ 2));
    printf ("%-26s %-26s %16.2e %16.2e %18.2e\n", cases{i,1}, loops{j,1}, max (away{i,j}), ...
            away{i,j}(end), max (turned));
  endfor
endfor
gsmbp_plot ("out/control.png", t, panel ([away{2,:}], loops(:,1)', ...
    "distance [mm]", ["a) " cases{2,1}]), panel ([away{3,:}], loops(:,1)', "distance [mm]", ...
    ["b) " cases{3,1}]), ...
            "title", "Stewart platform: distance from the plan");

puts ("\nthe first 2 s under control by the six ways to hold the loops\n");
printf ("%-14s %12s %16s %20s %22s %10s %12s\n", "way", "|phi| [m]", "|phidot| [m/s]", ...
        "|e|^2 - 1", "from projection [m]", "calls", "ms for 1 s");
few = 0:0.1:2;
for way = {"projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"}
  run = gsmbp_simulate (m, shifted, few, "input", feed, loops{2,2}{:}, "loops", way{1});
  if (strcmp (way{1}, "projection"))
    first = run;
  endif
  s = run.stats;
  printf ("%-14s %12.1e %16.1e %20.1e %22.1e %10d %12.2f\n", way{1}, s.drift.phi, ...
          s.drift.phidot, max (abs (sum (run.x(:, ...
              4:7) .^ 2, 2) - 1)), max (max (abs (run.x(:,1:3) - first.x(:,1:3)))), ...
          s.calls, 500 * s.seconds);
endfor
puts ("\n");
gsmbp_timing (m, 1, x(200,:)', "input", force(200,:)');
diary off

## ------------------------------------------------------ what it looks like
plan_run = struct ("t", t, "q", x(:,1:25));
gsmbp_animate (m, plan_run, "out/skeleton.png", "times", 2, "trace", "platform", "centres", ...
               false, "title", "Stewart platform");
gsmbp_animate (m, plan_run, "out/motion.gif", "times", 0.5:0.08:5.5, "fps", 12.5, "centres", ...
               false, "title", "Stewart platform", "width", 440);
