## Heavy symmetric top: nutation and precession against the integrals that solve it, what is
## conserved and for how long, the sleeping top, and the same top in Euler's angles where these are
## singular; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## state of the top tilted by THETA about x, turned about z at the rate PHID, its spin (all of w3) S
function x = start (theta, phid, s)
  x = [cos(theta / 2); sin(theta / 2); 0; 0; 0; phid * sin(theta); s];
endfunction

## the axis of the top (rows) from states (rows)
function a = axis_of (x)
  a = [2 * (x(:,2) .* x(:,4) + x(:,1) .* x(:,3)), 2 * (x(:,3) .* x(:,4) - x(:,1) .* x(:,2)), ...
       x(:,1).^2 - x(:,2).^2 - x(:,3).^2 + x(:,4).^2];
endfunction

function R = turning (e)
  v = e(2:4)(:);
  R = (2 * e(1) ^ 2 - 1) * eye (3) + 2 * (v * v') + 2 * e(1) ...
      * [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
endfunction

## what is conserved: energy, angular momentum about z, about the axis (rows)
function c = conserved (p, x)
  I = p.i1 + p.m * p.l ^ 2;
  for k = 1:rows (x)
    L = turning (x(k,1:4)) * ([I; I; p.i3] .* x(k,5:7)');
    c(k,:) = [x(k,5:7).^2 * [I; I; p.i3] / 2 + p.m * p.g * p.l * axis_of(x(k,:))(3), L(3), ...
              p.i3 * x(k,7)];
  endfor
endfunction

## the closed form: u = cos (nutation) swings between two roots of a cubic. Limits [rad], period
## [s], precession in one period [rad]
function [limits, period, advance] = closed_form (p, x)
  I = p.i1 + p.m * p.l ^ 2;
  c = conserved (p, x');
  mgl = p.m * p.g * p.l;
  E = c(1) - c(3) ^ 2 / (2 * p.i3);
  u = sort (real (roots (conv ([-1 0 1], [-2*mgl, 2*E] / I) ...
                           - [0, conv([-c(3), c(2)], [-c(3), c(2)])] / I ^ 2)));
  limits = sort (acos (min (u(1:2), 1)))';
  period = 4 * ellipke ((u(2) - u(1)) / (u(3) - u(1))) / sqrt (2 * mgl / I * (u(3) - u(1)));
  at = @(s) (u(1) + u(2)) / 2 - (u(2) - u(1)) / 2 * cos (s);
  advance = 2 ...
      * quadgk (@(s) (c(2) - c(3) * at (s)) ./ (I * (1 - at (s) .^ 2)) ./ sqrt (2 * mgl / I ...
                    * (u(3) - at (s))), 0, pi);
endfunction

## --------------------------------------------------------------- the models
cpu = gsmbp_derive ("spinning_top.mac");
cpu2 = gsmbp_derive ("spinning_top_angles.mac", "out");
printf (["derivation: %.1f s of processor time; in angles %.1f s; Maxima's start " ...
         "included\n"], cpu, cpu2);
m = gsmbp_build ("spinning_top");
angles = gsmbp_build ("spinning_top_angles", "directory", "out");
p = m.par;
I = p.i1 + p.m * p.l ^ 2;
mgl = p.m * p.g * p.l;
printf (["%d coordinates, %d speeds, true mobility %d; the same in angles: %d and " "%d\n\n"], ...
        m.sizes.nq, m.sizes.nu, m.mobility.true, angles.sizes.nq, angles.sizes.nu);

## --------------------------------------- one spin, four ways to let it go
tilt = pi / 6;
spin = 250;
slow = min (roots ([I * cos(tilt), -p.i3 * spin, mgl]));   # rate of regular precession
motions = {"loops", -6; "cusps", 0; "waves", 2.5; "regular", slow};
tight = {"rtol", 1e-13, "atol", 1e-13};
t = linspace (0, 1, 1001)';
printf ("released at %.0f degrees with a spin of %g rad/s\n", tilt * 180 / pi, spin);
printf ("%-10s %18s %22s %12s %14s %30s\n", "axis draws", "precession [rad/s]", ...
        "nutation [degrees]", "period [s]", "turns/period", "after 10 periods, deviation of");
printf ("%96s %12s\n", "nutation", "precession");
for k = 1:rows (motions)
  x0 = start (tilt, motions{k,2}, spin);
  [limits, period, advance] = closed_form (p, x0);
  r = gsmbp_simulate (m, x0, [0, period, 10 * period], tight{:});
  a = axis_of (r.x);
  azimuth = atan2 (a(end,2), a(end,1)) - atan2 (a(1,2), a(1,1)) - 10 * advance;
  printf ("%-10s %18.4f %12.6f %9.6f %12.6f %14.6f %16.1e %12.1e\n", motions{k,1}, motions{k, ...
      2}, limits * 180 / pi, period, advance / (2 * pi), acos (a(end,3)) - tilt, ...
          mod (azimuth + pi, 2 * pi) - pi);
  run{k} = gsmbp_simulate (m, x0, t, tight{:});
  path{k} = axis_of (run{k}.x);
  nutation(:,k) = acos (path{k}(:,3)) * 180 / pi;
  heading(:,k) = unwrap (atan2 (path{k}(:,2), path{k}(:,1)));
  y = cell2mat (arrayfun (@(i) m.out (t(i), run{k}.x(i,:)'), (1:1001), "UniformOutput", false))';
  support(k,:) = [min(y(:,strcmp (m.outputs, "support.z"))), ...
                  max(y(:,strcmp (m.outputs, "support.z")))];
endfor
puts ("(limits: roots of the cubic; period: elliptic integral; precession: quadrature)\n");
printf ("the point is pressed down with %.2f to %.2f N; it weighs %.2f N\n\n", ...
        min (support(:,1)), max (support(:,2)), p.m * p.g);
names = motions(:,1)';
heading -= heading(1,:);
gsmbp_plot ("out/figure_angles.png", t, panel (nutation, names, "nutation [degrees]"), ...
            panel (heading, names, "precession [rad]"), "title", "Nutation and precession");

## ----------------------------------- against the reference of the test suite
lines = strsplit (strtrim (fileread (fullfile ("..", "..", "tests", "data", "08a_heavy_top", ...
                                       "reference.csv"))), "\n");
heads = strtrim (strsplit (lines{1}, ","));
data = cell2mat (cellfun (@(s) str2double (strsplit (s, ",")), lines(2:end)', "UniformOutput", ...
                          false));
column = @(name) data(:,strcmp (heads, name));
w0 = [0; 0; 100] + 2 * [-sin(0.4); 0; cos(0.4)];
x0 = [cos(0.2); 0; sin(0.2); 0; w0];
puts ("tests/data/08a_heavy_top, 28 digits: largest deviation of the axis over 1 s\n");
for tol = 10 .^ -(6:2:14)
  r = gsmbp_simulate (m, x0, column ("t"), "rtol", tol, "atol", tol);
  printf ("  tolerance %.0e: %8.1e with %5d calls, %.2f ms\n", tol, ...
          max (abs ((axis_of (r.x) - [column("e3x"), column("e3y"), column("e3z")])(:))), ...
          r.stats.calls, 1e3 * r.stats.seconds);
endfor
puts ("\n");

## ------------------------------------------------------ what is conserved
duration = 1000;
often = linspace (0, duration, 1001)';
puts ("1000 s, 40 000 turns: relative drift\n");
printf ("%-36s %10s %10s %10s %12s %10s %8s\n", "", "energy", "about z", "about axis", ...
        "|e| - 1", "calls", "s");
ways = {"projection, tolerance 1e-10", "projection", 1e-10; "not normalized, 1e-10", ...
        "baumgarte", 1e-10; "projection, tolerance 1e-13", "projection", 1e-13};
for k = 1:rows (ways)
  r = gsmbp_simulate (m, start (tilt, 0, spin), often, "loops", ways{k,2}, "rtol", ways{k,3}, ...
                      "atol", ways{k,3});
  c = conserved (p, r.x);
  printf ("%-36s %10.1e %10.1e %10.1e %12.1e %10d %8.2f\n", ways{k,1}, ...
          max (abs (c ./ c(1,:) - 1)), max (abs (sqrt (sumsq (r.x(:,1:4), 2)) - 1)), ...
          r.stats.calls, r.stats.seconds);
endfor
puts ("\n");

## -------------------------------------------------------- the sleeping top
critical = sqrt (4 * I * mgl) / p.i3;
printf (["sleeping top: stands upright above a spin of %.2f rad/s; pushed by 0.5 " "degrees\n"], ...
        critical);
printf ("%14s %26s %26s\n", "spin/critical", "largest nutation [degrees]", "closed form [degrees]");
for ratio = [0.9 0.98 1.02 1.1]
  x0 = start (0.5 * pi / 180, 0, ratio * critical);
  limits = closed_form (p, x0);
  r = gsmbp_simulate (m, x0, linspace (0, 20, 20001), tight{:});
  printf ("%14.2f %26.4f %26.4f\n", ratio, max (acos (axis_of (r.x)(:,3))) * 180 / pi, ...
          limits(2) * 180 / pi);
endfor
puts ("\n");

## ------------------------------------ Euler's angles, close to their singularity
## with equal angular momenta about z and about its axis the top rises until it stands upright,
## where precession and spin cannot be told apart
puts (["the top rises towards the vertical: Euler's angles z, x, z beside Euler " ...
       "parameters, 2 s, tolerance 1e-10\n"]);
printf ("%12s %20s %12s %12s %14s %12s %18s %16s\n", "Lz/L3 - 1", "least nutation [deg]", ...
        "calls", "in angles", "smallest step", "in angles", "deviation of axis", "close to it");
t2 = linspace (0, 2, 41)';
quiet = warning ("off", "all");   # what they say is in the last column
for k = 1:6
  miss = [1e-1 1e-2 1e-3 1e-4 1e-5 0](k);
  phid = p.i3 * spin * (1 + miss - cos (tilt)) / (I * sin (tilt) ^ 2);
  x0 = start (tilt, phid, spin);
  limits = closed_form (p, x0);
  by_parameters = gsmbp_simulate (m, x0, t2);
  [by_angles, info] = gsmbp_simulate (angles, [0, tilt, 0, phid, 0, spin - phid * cos(tilt)], ...
                                      t2, "maxsteps", 1e5);
  s = by_parameters.stats;
  z = by_angles.stats;
  q = by_angles.x;
  a = [sin(q(:,2)) .* sin(q(:,1)), -sin(q(:,2)) .* cos(q(:,1)), cos(q(:,2))];
  deviation = max (abs ((a - axis_of (by_parameters.x)(1:rows (a),:))(:)));
  least(k,1) = limits(1) * 180 / pi;
  steps(k,:) = [s.smallest_step, z.smallest_step];
  word = {"", sprintf(" (stopped at %.3f s)", by_angles.t(end))}{1 + (info != 0)};
  printf ("%12.0e %20.5f %12d %12d %14.1e %12.1e %18.1e %10d calls%s\n", miss, limits(1) ...
      * 180 / pi, s.calls, z.calls, s.smallest_step, ...
          z.smallest_step, deviation, z.angle_singularities, word);
endfor
warning (quiet);
gsmbp_plot ("out/figure_steps.png", least(1:5), panel (steps(1:5,:), ...
    {"Euler parameters", "Euler angles"}, ...
    "smallest step [s]"), "title", "How close to the vertical, and the step that it takes", ...
            "scale", "loglog", "xlabel", "least nutation [degrees]", "head", "nutation");
s = gsmbp_timing (m, 0, run{1}.x(end,:), "print", false);
z = gsmbp_timing (angles, 0, by_angles.x(1,:), "print", false);
printf ("one call of the right-hand side: %.0f ns; in angles %.0f ns\n", 1e9 * s.rhs, 1e9 * z.rhs);
diary off

## ------------------------------------------------------ what it looks like
## spheres by their upper halves; the path of the axis on each, then the top itself with one of
## them, ten times slower than it is
circle = [cos(linspace (0, 2 * pi, 73)); sin(linspace (0, 2 * pi, 73)); zeros(1, 73)];
arc = [circle(1,1:37); zeros(1, 37); circle(2,1:37)];
sphere = zeros (3, 0);
for k = 0:15:75
  sphere = [sphere, NaN(3, 1), cosd(k) * circle + [0; 0; sind(k)]];
endfor
for k = 0:30:150
  sphere = [sphere, NaN(3, 1), [cosd(k), -sind(k), 0; sind(k), cosd(k), 0; 0, 0, 1] * arc];
endfor
colors = {"#cc3318", "#00459a", "#1a7f37"};
picture = {};
for k = 1:3
  aside = [2.15 * (k - 1); 0; 0];
  picture = [picture; ...
             {aside + sphere, "lines lw 0.5 lc rgb '#bbbbbb'", ""; aside + path{k}', ...
              sprintf("lines lw 2 lc rgb '%s'", colors{k}), names{k}}];
endfor
film ("out/sphere.png", {picture}, "view", [0, 68], "width", 900);

reach = 0.12;   # how far above the point the axis is drawn
rim = [0.055 * circle(1:2,:); 0.08 * ones(1, 73)];
spokes = zeros (3, 0);
for k = 1:12:61
  spokes = [spokes, NaN(3, 1), rim(:,k), [0; 0; 0.1], NaN(3, 1), rim(:,k), [0; 0; 0]];
endfor
every = 0.005;
shown = gsmbp_simulate (m, start (tilt, motions{1,2}, spin), 0:every:0.6);
trace = reach * axis_of (run{1}.x(t <= 0.6,:))';
for k = 1:rows (shown.x) - 1
  R = turning (shown.x(k,1:4));
  frames{k} = {reach * sphere, "lines lw 0.5 lc rgb '#dddddd'", ""; trace(:, ...
      1:max (2, ...
             round ((k - 1) * every * 1000) ...
               + 1)), "lines lw 2 lc rgb '#cc3318'", "path of the axis"
               R * [0, 0; 0, 0; 0, reach], "lines lw 3 lc rgb '#222222'", ""; R ...
                   * spokes, "lines lw 1 lc rgb '#00459a'", ""; R ...
                   * rim, "lines lw 2.5 lc rgb '#00459a'", "top"};
  titles{k} = sprintf ("t = %.3f s", shown.t(k));
endfor
film ("out/motion.gif", frames, "view", [0, 25], "width", 340, "axis", 0.05, "titles", titles);
