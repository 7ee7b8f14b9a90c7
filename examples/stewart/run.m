## A Stewart-Gough platform on six driven legs: kinematics both ways beside closed formulas, the forces that a motion needs, the motion under computed
## force and under control; everything goes into out/.

warning ("off", "Octave:shadowed-function");   # this file has the name of a function of Octave

## points of the legs on the base and on the platform, 3 x 6
function [base, top] = points (p)
  turn = @(k) [cosd(120*k), -sind(120*k), 0; sind(120*k), cosd(120*k), 0; 0, 0, 1];
  base = [turn(0) * [p.rb p.rb; p.wb -p.wb; 0 0], turn(1) * [p.rb p.rb; p.wb -p.wb; 0 0], turn(2) * [p.rb p.rb; p.wb -p.wb; 0 0]];
  top = [turn(2) * [-p.rp; p.wp; 0], turn(1) * [-p.rp; -p.wp; 0], turn(0) * [-p.rp; p.wp; 0], turn(2) * [-p.rp; -p.wp; 0], turn(1) * [-p.rp; p.wp; 0], turn(0) * [-p.rp; -p.wp; 0]];
endfunction

## a pose [x; y; z; roll; pitch; yaw] with its rates and accelerations, R = Rx(roll) Ry(pitch) Rz(yaw): Euler parameters, angular velocity and
## acceleration in platform axes
function [e, w, wd, R] = turning (pose, rate, acc)
  c = cos (pose(4:6) / 2);
  s = sin (pose(4:6) / 2);
  times = @(a, b) [a(1)*b(1) - a(2:4)'*b(2:4); a(1)*b(2:4) + b(1)*a(2:4) + cross(a(2:4), b(2:4))];
  e = times (times ([c(1); s(1); 0; 0], [c(2); 0; s(2); 0]), [c(3); 0; 0; s(3)]);
  R = eye (3) + 2 * e(1) * hat (e(2:4)) + 2 * hat (e(2:4)) ^ 2;
  [t, u] = deal (pose(5), pose(6));
  [td, ud] = deal (rate(5), rate(6));
  B = [cos(t)*cos(u), sin(u), 0; -cos(t)*sin(u), cos(u), 0; sin(t), 0, 1];
  Bd = [-td*sin(t)*cos(u) - ud*cos(t)*sin(u), ud*cos(u), 0; td*sin(t)*sin(u) - ud*cos(t)*cos(u), -ud*sin(u), 0; td*cos(t), 0, 0];
  w = B * rate(4:6);
  wd = B * acc(4:6) + Bd * rate(4:6);
endfunction

function H = hat (v)
  H = [0 -v(3) v(2); v(3) 0 -v(1); -v(2) v(1) 0];
endfunction

## closed inverse kinematics: angles a, b and stroke s of each leg (3 x 6), speed and acceleration of the strokes (6 x 1), directions
function [q, sd, sdd, n] = legs_by_hand (p, pose, rate, acc)
  [base, top] = points (p);
  [~, w, wd, R] = turning (pose, rate, acc);
  D = pose(1:3) + R * top - base;
  V = rate(1:3) + R * hat (w) * top;
  A = acc(1:3) + R * (hat (wd) + hat (w) ^ 2) * top;
  L = sqrt (sum (D .^ 2));
  n = D ./ L;
  q = [atan2(-n(2,:), n(3,:)); asin(n(1,:)); L - p.lc - p.lr];
  sd = sum (n .* V)';
  sdd = (sum (n .* A) + (sum (V .^ 2) - sd' .^ 2) ./ L)';
endfunction

## forces along the legs, if these have no mass: Newton and Euler for the platform
function f = forces_by_hand (p, pose, rate, acc)
  [~, top] = points (p);
  [~, w, wd, R] = turning (pose, rate, acc);
  [~, ~, ~, n] = legs_by_hand (p, pose, rate, acc);
  c = [0; 0; p.hp];
  J = diag ([p.jx, p.jx, p.jz]);
  pull = p.mp * (acc(1:3) + R * (hat (wd) + hat (w) ^ 2) * c + [0; 0; p.g]);
  turn = R * (J * wd + cross (w, J * w));
  f = [n; cross(R * (top - c), n)] \ [pull; turn];
endfunction

## coordinates, speeds and accelerations of the whole scene for a motion of the platform; the legs' rates from the constraints
function [q, u, ud, wrong] = whole (m, pose, rate, acc)
  [e, w, wd, ~] = turning (pose, rate, acc);
  [legs, sd, sdd] = legs_by_hand (m.par, pose, rate, acc);
  q = [pose(1:3); e; legs(:)];
  u = [rate(1:3); w; zeros(18, 1)];
  ud = [acc(1:3); wd; zeros(18, 1)];
  [~, ~, H] = m.con (0, q, u);
  u(7:24) = -H(:,7:24) \ (H(:,1:6) * u(1:6));
  [phi, ~, H, gam] = m.con (0, q, u);
  ud(7:24) = H(:,7:24) \ (gam - H(:,1:6) * ud(1:6));
  wrong = [max(abs (phi)), max(abs (u(9:3:24) - sd)), max(abs (ud(9:3:24) - sdd))];
endfunction

function p = panel (y, names, label)
  p = struct ("y", y, "names", {names}, "label", label);
endfunction

cd (fileparts (mfilename ("fullpath")));
addpath (fullfile (pwd (), "..", "..", "octave"));
if (! exist ("out", "dir"))
  mkdir ("out");
endif
if (exist (fullfile ("out", "report.txt"), "file"))
  delete (fullfile ("out", "report.txt"));
endif
diary (fullfile ("out", "report.txt"));

## ---------------------------------------------------------------- the model
[cpu, wall] = gsmbp_derive ("stewart.mac");
printf ("derivation: %.1f s of processor time, %.1f s by the clock, Maxima's start included\n", cpu, wall);
m = gsmbp_build ("stewart");
x0 = m.initial;
gsmbp_mobility (m, x0);
strokes = arrayfun (@(k) sprintf ("s%d", k), 1:6, "UniformOutput", false);
leg = arrayfun (@(k) sprintf ("leg %d", k), 1:6, "UniformOutput", false);

## -------------------------------------- from platform to legs, and back
puts ("\nplatform to legs: the program's loops closed with the platform held, against the closed form\n");
printf ("%-46s %16s %40s\n", "x, y, z [m], roll, pitch, yaw [degrees]", "difference", "strokes [mm]");
for pose = [0 0 0.8 0 0 0; 0.1 0 0.8 0 0 0; 0 0 0.85 15 0 0; 0.05 -0.05 0.75 0 -12 20]'
  pose(4:6) *= pi / 180;
  e = turning (pose, zeros (6, 1), zeros (6, 1));
  x = gsmbp_assemble (m, [pose(1:3); e; x0(8:25)], "hold", {"x", "y", "z", "e0", "e1", "e2", "e3"});
  q = legs_by_hand (m.par, pose, zeros (6, 1), zeros (6, 1));
  printf ("%-46s %16.1e %10.2f %7.2f %7.2f %7.2f %7.2f %7.2f\n", sprintf ("%5.2f ", pose(1:3), 180 / pi * pose(4:6)), max (abs (x(8:25) - q(:))), 1e3 * q(3,:));
endfor
X = gsmbp_assemble (m, x0, "hold", strokes, "branches", 60);
X(4:7,:) .*= sign (X(4,:));
[~, own] = unique (round (1e6 * X(1:7,:)') + 0, "rows");
printf ("legs to platform: six strokes as at the start, 61 guesses: %d assemblies; the platform has %d places:\n", columns (X), numel (own));
printf ("%10s %10s %10s %26s\n", "x [m]", "y [m]", "z [m]", "turned by [degrees]");
places = sortrows ([X(1:3,own)', 360 / pi * acos(min (X(4,own)', 1))], [-3, -1, -2]);
printf ("%10.4f %10.4f %10.4f %26.3f\n", (round (1e9 * places) / 1e9 + 0)');

## --------------------------------------------------------------- the motion
## in 6 s: up by 5 cm, twice round a circle of 10 cm leaning inwards by 10 degrees, back; the motion is the cubic spline through these knots
knots = 0:0.05:6;
blend = gsmbp_evaluate (gsmbp_plan ("septic", [0 1 1 0], [0.5 1.5 4.5 5.5]), knots);
turns = 2 * pi * 2 * gsmbp_evaluate (gsmbp_plan ("septic", [0 1], [0.75 5.25]), knots);
lean = 10 * pi / 180;
plan = gsmbp_plan ("table", knots, [0.1 * blend .* cos(turns); 0.1 * blend .* sin(turns); m.par.h + 0.05 * blend; ...
                                    lean * blend .* sin(turns); -lean * blend .* cos(turns); zeros(1, numel (knots))]', 3);
t = (0:0.005:6)';
nt = numel (t);
f = gsmbp_evaluate (plan, t, 2);
x = zeros (nt, 49);
force = zeros (nt, 6);
power = zeros (nt, 2);
wrong = zeros (nt, 4);
light = gsmbp_set (m, "mc", 0, "jc", 0, "mr", 0, "jr", 0, "kc", 0);
for k = 1:nt
  [q, u, ud, wrong(k,1:3)] = whole (m, f(:,k,1), f(:,k,2), f(:,k,3));
  [~, ~, H] = m.con (t(k), q, u);
  own = zeros (24, 6);
  own(9:3:24,:) = eye (6);
  solved = [own, H'] \ m.inv (t(k), q, u, ud, zeros (6, 1));   # tree's efforts = drives' + H' lambda
  x(k,:) = [q; u];
  force(k,:) = solved(1:6);
  e = m.ene (t(k), x(k,:)', force(k,:)');
  power(k,:) = [sum(e(1:3)), u(9:3:24)' * solved(1:6)];
  without = [own, H'] \ light.inv (t(k), q, u, ud, zeros (6, 1));
  wrong(k,4) = max (abs (without(1:6) - forces_by_hand (m.par, f(:,k,1), f(:,k,2), f(:,k,3))));
endfor
printf ("\nthe motion: loops %.0e m; strokes' speeds and accelerations against the closed form %.0e m/s, %.0e m/s^2\n", max (wrong(:,1:3)));
printf ("legs without mass and springs: forces against Newton and Euler for the platform alone %.0e N\n", max (wrong(:,4)));
gain = cumtrapz (t, power(:,2));
printf ("work of the drives and change of energy: %.6f and %.6f J after 2 s\n", gain(t == 2), power(t == 2,1) - power(1,1));
printf ("strokes from %.1f to %.1f mm, speeds up to %.3f m/s; forces of the drives from %.1f to %.1f N (at rest %.2f N each)\n\n", ...
        1e3 * min (min (x(:,10:3:25))), 1e3 * max (max (x(:,10:3:25))), max (max (abs (x(:,34:3:49)))), min (force(:)), max (force(:)), force(1,1));
printf ("%8s %10s %10s %10s %10s %10s %10s\n", "t [s]", "f1 [N]", "f2", "f3", "f4", "f5", "f6");
for k = 1:200:nt
  printf ("%8.1f %10.4f %10.4f %10.4f %10.4f %10.4f %10.4f\n", t(k), force(k,:));
endfor
gsmbp_csv ("out/motion_plan.csv", [{"t", "x", "y", "z", "roll", "pitch"}, strokes, strrep(strokes, "s", "f")], [t, f(1:5,:,1)', x(:,10:3:25), force]);
gsmbp_plot ("out/legs.png", t, panel (1e3 * x(:,10:3:25), leg, "stroke [mm]"), panel (force, leg, "force of drive [N]"), "title", "Stewart platform: strokes and forces along the motion");

## ---------------------------------- under computed force, and under control
feed = gsmbp_plan ("table", t, force, 3);
reference = gsmbp_plan ("table", t, x, 3);
K = zeros (6, 49);
K(:,10:3:25) = 4e4 * eye (6);
K(:,34:3:49) = 800 * eye (6);
shifted = gsmbp_assemble (m, [x0(1:2) + [0.01; 0]; x0(3:end)], "hold", {"x", "y", "z", "e0", "e1", "e2", "e3"});
heavy = gsmbp_set (m, "mp", 1.25 * m.par.mp, "jx", 1.25 * m.par.jx, "jz", 1.25 * m.par.jz);
cases = {"as planned", m, x0; "start 1 cm aside", m, shifted; "platform heavier by 25 %", heavy, x0};
loops = {"computed force", {}; "with feedback", {"gain", K, "reference", reference}};
puts ("\nsimulation (DOP853, 1e-10, projection): distance of the platform from its plan\n");
printf ("%-26s %-26s %16s %16s %18s\n", "", "drives", "largest [mm]", "at 6 s [mm]", "turned [mrad]");
for i = 1:rows (cases)
  for j = 1:2
    run = gsmbp_simulate (cases{i,2}, cases{i,3}, t, "input", feed, loops{j,2}{:});
    away{i,j} = 1e3 * sqrt (sum ((run.x(:,1:3) - f(1:3,:,1)') .^ 2, 2));
    turned = 2e3 * sqrt (max (0, 1 - min (1, abs (sum (run.x(:,4:7) .* x(:,4:7), 2))) .^ 2));
    printf ("%-26s %-26s %16.2e %16.2e %18.2e\n", cases{i,1}, loops{j,1}, max (away{i,j}), away{i,j}(end), max (turned));
  endfor
endfor
gsmbp_plot ("out/control.png", t, panel ([away{2,:}], loops(:,1)', "start 1 cm aside [mm]"), panel ([away{3,:}], loops(:,1)', "platform heavier [mm]"), ...
            "title", "Stewart platform: distance from the plan");

puts ("\nthe first 2 s under control by the six ways to hold the loops\n");
printf ("%-14s %12s %16s %20s %22s %10s %12s\n", "way", "|phi| [m]", "|phidot| [m/s]", "|e|^2 - 1", "from projection [m]", "calls", "ms for 1 s");
few = 0:0.1:2;
for way = {"projection", "baumgarte", "partitioning", "nullspace", "svd", "kane"}
  run = gsmbp_simulate (m, shifted, few, "input", feed, loops{2,2}{:}, "loops", way{1});
  if (strcmp (way{1}, "projection"))
    first = run;
  endif
  s = run.stats;
  printf ("%-14s %12.1e %16.1e %20.1e %22.1e %10d %12.2f\n", way{1}, s.drift.phi, s.drift.phidot, max (abs (sum (run.x(:,4:7) .^ 2, 2) - 1)), max (max (abs (run.x(:,1:3) - first.x(:,1:3)))), ...
          s.calls, 500 * s.seconds);
endfor
puts ("\n");
gsmbp_timing (m, 1, x(200,:)', "input", force(200,:)');
diary off

## ------------------------------------------------------ what it looks like
plan_run = struct ("t", t, "q", x(:,1:25));
gsmbp_animate (m, plan_run, "out/skeleton.png", "times", 2, "trace", "platform", "centres", false, "title", "Stewart platform");
gsmbp_animate (m, plan_run, "out/motion.gif", "times", 0.5:0.08:5.5, "fps", 12.5, "centres", false, "title", "Stewart platform", "width", 440);
