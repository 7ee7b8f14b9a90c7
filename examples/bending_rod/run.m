## Slider-crank with a rod that bends: the deflection of the rod's middle against the speed of the
## crank, with and without foreshortening, beside a quasi-static formula; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## turns 7 and 8 of a run that starts straight at the speed W: crank angle, outputs, energy drift
function [theta, y, r] = turns (m, w)
  p = m.par;
  ## as the rigid mechanism stands and moves with the crank outwards
  x0 = gsmbp_assemble (m, [0; 0; p.l + p.r; 0; 0; w; -w*(1 + p.r/p.l); 0; 0; 0], "hold", "theta");
  t = linspace (0, 8 * 2*pi / w, 8*360 + 1)';
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-9, "start", "project");
  late = t >= t(end) * 3/4;
  theta = r.x(late,1);
  k = find (late)';
  y = cell2mat (arrayfun (@(k) m.out (t(k), r.x(k,:)'), k, "UniformOutput", false))';
endfunction

## middle of the rod where the inertia of the straight rod bends it, first shape, no vibration
function v = quasi_static (p, theta, w)
  m = p.rho * pi * p.d ^ 2 / 4 * p.l;
  phi = -asin (p.r / p.l * sin (theta));   # of the rod, from the slide
  phid = -p.r * w * cos (theta) ./ (p.l * cos (phi));
  phidd = (p.r * w ^ 2 * sin (theta) + p.l * phid .^ 2 .* sin (phi)) ./ (p.l * cos (phi));
  across = p.r * w ^ 2 * (cos (theta) .* sin (phi) - sin (theta) .* cos (phi));
  load_ = -m * sqrt (2) / pi * (2 * across + p.l * phidd);
  v = sqrt (2) * load_ * p.l ^ 3 / (pi ^ 4 * p.E * pi * p.d ^ 4 / 64);
endfunction

m = derived_model ("bending_rod");
gsmbp_derive ("bending_rod_linear.mac", "out");
linear = gsmbp_build ("bending_rod_linear", "directory", "out");
p = m.par;
mass = p.rho * pi * p.d ^ 2 / 4 * p.l;
first = pi ^ 2 * sqrt (p.E * pi * p.d ^ 4 / 64 / (mass * p.l ^ 3));
printf ("rod: %.4f kg, first frequency %.2f rad/s between two pins\n\n", mass, first);

## ----------------------------------------------------- against the speed
speeds = [10 20 40 60 80 100 120 140 160]';
puts ("turns 7 and 8: largest deflection of the rod's middle [mm]\n");
printf ("%14s %12s %12s %14s %22s %14s\n", "speed [rad/s]", "second", "linear", "quasi-static", ...
        "second/quasi-static", "strain [1]");
for k = 1:numel (speeds)
  w = speeds(k);
  [theta, y] = turns (m, w);
  [~, z] = turns (linear, w);
  most(k,:) = 1e3 * [max(abs (y(:,1))), max(abs (z(:,1))), max(abs (quasi_static (p, theta, w)))];
  printf ("%14g %12.5f %12.5f %14.5f %22.5f %14.2e\n", w, most(k,:), most(k,1) / most(k,3), ...
          max (abs (y(:,2))));
endfor
names = {"second", "linear", "quasi-static"};
gsmbp_plot ("out/figure_speeds.png", speeds, ...
            struct ("y", most, "names", {names}, "style", "linespoints", "label", ...
                    "largest deflection [mm]"), "xlabel", "speed of the crank [rad/s]", "title", ...
            "The rod's middle against the speed", "head", "speed");

## ----------------------------------------------------- two turns
w = 120;
[theta, y, r] = turns (m, w);
[theta_linear, z] = turns (linear, w);
gsmbp_plot ("out/figure_turns.png", (theta - 12*pi) * 180 / pi, ...
            panel (1e3 * [y(:,1), interp1(theta_linear, z(:,1), theta, "linear", "extrap"), ...
                          quasi_static(p, theta, w)], names, "deflection [mm]"), ...
            panel (y(:,3), {"second"}, "moment in the middle [N m]"), "xlabel", ...
            "crank angle [degrees]", "title", "Two turns at 120 rad/s", "head", "theta");
undamped = gsmbp_set (m, "zeta", 0);
[~, ~, r] = turns (undamped, w);
E = arrayfun (@(k) sum (undamped.ene (r.t(k), r.x(k,:)')(1:3)), 1:20:numel (r.t));
printf (["\nwithout damping at %g rad/s: energy kept to %.1e of it over eight turns; gap of " ...
         "the loop %.1e m\n\n"], w, max (abs (E - E(1))) / E(1), r.stats.drift.phi);

## ----------------------------------------------------- what it costs
gsmbp_timing (m, 0, r.x(101,:));
puts ("\n");
x0 = r.x(1,:)';
gsmbp_workprecision (m, x0, [0 2*pi/w], "rk4", [2e-4 1e-4 5e-5], "dp853", 10 .^ -(4:2:12), ...
                     "file", "out/speed_error.png", "seconds", 0.05);
diary off
