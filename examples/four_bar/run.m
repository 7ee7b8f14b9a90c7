## Hoeken's four-bar: both branches, the coupler curve, transmission angle, torque and pin forces at
## constant speed, dead centres, change points, beside closed formulas; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## the loop equation solved by hand: angles [beta, psi] for crank angles THETA (column); SIDE 1: C
## left of the line from B to D, -1: right of it
function q = by_hand (p, theta, side)
  B = p.la * exp (1i * theta);
  r = p.ld - B;
  bend = acos ((p.lb^2 + abs (r).^2 - p.lc^2) ./ (2 * p.lb * abs (r)));
  coupler = arg (r) + side * bend;
  C = B + p.lb * exp (1i * coupler);
  q = [arg(exp (1i * (coupler - theta))), arg(C - p.ld)];
endfunction

## kinetic and potential energy at crank angles THETA with crank speed W, from the same triangle
function E = energy_by_hand (p, theta, w)
  q = by_hand (p, theta, 1);
  coupler = theta + q(:,1);
  psi = q(:,2);
  wc = w * p.la * sin (psi - theta) ./ (p.lb * sin (coupler - psi));
  wr = w * p.la * sin (coupler - theta) ./ (p.lc * sin (coupler - psi));
  B = p.la * exp (1i * theta);
  vB = 1i * w * B;
  arm = p.lb * exp (1i * coupler);
  bar = 2 * p.mu * p.lb;
  T = p.mu * p.la^3 / 6 * w^2 + p.mu * p.lc^3 / 6 * wr.^2 + bar ...
      * abs (vB + 1i * wc .* arm).^2 / 2 + bar * p.lb^2 / 6 * wc.^2 + p.mp ...
      * abs (vB + 2i * wc .* arm).^2 / 2;
  V = p.g ...
      * imag (p.mu * p.la / 2 * B + bar * (B + arm) + p.mu * p.lc^2 / 2 * exp (1i * psi) + p.mp ...
                * (B + 2 * arm));
  E = T + V;
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("four_bar");
gsmbp_mobility (m, gsmbp_assemble (m, m.initial, "hold", "theta"));
puts ("\n");
p = m.par;

## ---------------------------------------------- assembly: the two branches
puts (["assembly at a crank angle of 60 degrees from one rough guess and 20 " ...
       "around it, crank held [degrees]\n"]);
printf ("%-10s %10s %10s %26s\n", "branch", "beta", "psi", "difference to closed form");
found = gsmbp_assemble (m, [60; 0; 120] * pi / 180, "hold", "theta", "branches", 20);
for k = 1:columns (found)
  angles = arg (exp (1i * found(2:3,k)'));
  side = sign (sin (angles(2) - angles(1) - pi / 3));
  wrong = exp (1i * angles) - exp (1i * by_hand (p, pi / 3, side));
  printf ("%-10d %10.4f %10.4f %26.1e\n", k, 180 / pi * angles, max (abs (wrong)));
endfor
puts ("the rocker held at 40 degrees, out of its range:\n");
try
  gsmbp_assemble (m, [1; -0.1; 40 * pi / 180], "hold", "psi");
catch problem
  printf ("%s\n\n", problem.message);
end_try_catch

## ------------------------------------- one turn a second: the coupler curve
w = 2 * pi;
turn = mkpp ([0 1], [w 0]);
t = (0:360)' / 360;
r = gsmbp_inverse (m, turn, t);
y = cell2mat (arrayfun (@(k) m.out (t(k), r.x(k,:)', r.v(k,:)'), 1:numel (t), "UniformOutput", ...
                        false))';
value = @(name) y(:, strcmp (m.outputs, name));
hand = by_hand (p, w * t, 1);
printf (["one turn, crank at %.4g rad/s; closed form and program differ by at most " ...
         "%.1e rad\n"], w, max (max (abs (exp (1i * r.q(:,2:3)) - exp (1i * hand)))));
straight = 91:271;   # crank from 90 to 270 degrees
height = value ("pen_y")(straight);
printf (["straight part of the coupler curve: %.1f mm in half a turn, %.2f mm high; the rest " ...
         "of the curve rises by %.1f mm\n"], ...
        1e3 * range (value ("pen_x")(straight)), 1e3 * range (height), 1e3 ...
            * (max (value ("pen_y")) - max (height)));
pen = diff (value ("pen_x")(straight)) * 360;
printf ("speed of the pen there: %.3f to %.3f m/s\n", min (abs (pen)), max (abs (pen)));

## transmission angle: between coupler and rocker; least and greatest where the crank lies on the
## base
mu = acos (abs (cos (r.q(:,3) - r.q(:,1) - r.q(:,2))));
inner = @(s) acos ((p.lb^2 + p.lc^2 - (p.ld - s * p.la)^2) / (2 * p.lb * p.lc));
printf (["transmission angle: %.3f to %.3f degrees (closed form %.3f at crank angle " ...
         "0, %.3f at 180)\n"], 180 / pi * [min(mu), max(mu), inner(1), inner(-1)]);

## dead centres of the rocker: crank and coupler in line
angle = @(bar) acos ((bar^2 + p.ld^2 - p.lc^2) / (2 * bar * p.ld));
ends = [angle(p.lb + p.la), pi + angle(p.lb - p.la)];
at = gsmbp_inverse (m, turn, ends / w);
forth = diff (ends);
printf (["dead centres of the rocker at crank angles %.3f and %.3f degrees: rocker at %.3f and " ...
         "%.3f, its speed there %.0e rad/s\n"], ...
        180 / pi * ends, 180 / pi * at.q(:,3), max (abs (at.u(:,3))));
printf (["the rocker goes back in %.1f and forth in %.1f degrees of the crank: time " ...
         "ratio %.3f\n\n"], 180 / pi * [2*pi - forth, forth], ...
        max (forth / (2*pi - forth), (2*pi - forth) / forth));
gsmbp_plot ("out/angles.png", 360 * t, panel (180 / pi * [r.q(:,3), mu], ...
    {"rocker angle", "transmission angle"}, "angle [degrees]"), ...
            "xlabel", "crank angle [degrees]", "head", "crank", "title", ...
                "Hoeken's four-bar: rocker and transmission");
gsmbp_plot ("out/straight.png", 360 * t(straight), panel (1e3 * (height - 0.4), {"pen"}, ...
    "height above 0.4 m [mm]"), ...
            "xlabel", "crank angle [degrees]", "head", "crank", "title", ...
                "Hoeken's four-bar: the straight part of the coupler curve");

## ------------------------------------------------ torque and forces in the pins
h = 1e-3;
by_energy = (energy_by_hand (p, w*t - 2*h, w) - 8 * energy_by_hand (p, w*t - h, w) + 8 ...
               * energy_by_hand (p, w*t + h, w) - energy_by_hand (p, w*t + 2*h, w)) / (12 * h);
printf (["torque at the crank: %.4f to %.4f N m; differs from dE/dtheta of the " ...
         "closed form by at most %.1e N m\n"], min (r.tau), max (r.tau), ...
        max (abs (r.tau - by_energy)));
weight = p.g * (p.mu * (p.la + 2 * p.lb + p.lc) + p.mp);
printf ("%-32s %10s %10s %10s %10s %20s %18s\n", "largest force in the pin [N]", "A", "B", "C", ...
        "D", "mean of A.y + D.y", "weight of links");
for turns = [0.5 1 2 4]
  fast = gsmbp_inverse (m, mkpp ([0 1/turns], [w*turns 0]), t / turns);
  f = cell2mat (arrayfun (@(k) m.out (fast.t(k), fast.x(k,:)', fast.v(k,:)'), 1:360, ...
                          "UniformOutput", false));
  pick = @(name) f(strcmp (m.outputs, name),:);
  pins = arrayfun (@(c) max (hypot (pick ([c ".x"]), pick ([c ".y"]))), "abcd");
  printf ("%-32s %10.3f %10.3f %10.3f %10.3f %20.10f %18.10f\n", ...
          sprintf ("%g turns a second", turns), pins, mean (pick ("a.y") + pick ("d.y")), ...
          weight);
endfor
puts ("\n");
forces = arrayfun (@(c) hypot (value ([c ".x"]), value ([c ".y"])), "abcd", "UniformOutput", false);
gsmbp_plot ("out/forces.png", 360 * t, panel (r.tau, {"torque of the motor"}, ...
    "torque [N m]"), panel ([forces{:}], {"pin A", "pin B", "pin C", "pin D"}, "force [N]"), ...
            "xlabel", "crank angle [degrees]", "head", "crank", "title", ...
                "One turn a second: torque and forces in the pins");

## ------------------------------------------------------ six ways through the loop
long = mkpp ([0 10], [w 0]);
puts ("ten turns with the computed torque (DOP853, 1e-10), by the six ways to hold the loop\n");
printf ("%-14s %12s %16s %22s %10s %14s\n", "way", "|phi| [m]", "|phidot| [m/s]", ...
        "crank angle [rad]", "calls", "ms for 1 s");
for way = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"}
  run = gsmbp_simulate (m, r.x(1,:)', 0:0.1:10, "motion", long, "loops", way{1});
  s = run.stats;
  printf ("%-14s %12.1e %16.1e %22.1e %10d %14.3f\n", way{1}, s.drift.phi, s.drift.phidot, ...
          max (abs (run.x(:,1) - w * run.t)), s.calls, 100 * s.seconds);
endfor
puts ("(largest values; the crank angle is the deviation from the planned one)\n\n");

## --------------------------------- change points: the same scene as a parallelogram
even = gsmbp_set (m, "lc", p.la, "lb", p.ld, "g", 0);
x0 = gsmbp_assemble (even, [0.5; -0.5; 0.5; w; -w; w], "hold", {"theta"});
warning ("off", "gsmbp:singular");
puts (["lengths of a parallelogram (crank = rocker, coupler = base), no gravity, " ...
       "no torque, 3 turns: the linkage passes its change points at 0 and 180 " ...
       "degrees\n"]);
printf ("%-14s %18s %16s %26s %16s\n", "way", "points reported", "first at [s]", ...
        "|rocker - crank| [rad]", "energy [J/J]");
for way = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"}
  [run, info] = gsmbp_simulate (even, x0, 0:0.01:3, "loops", way{1});
  e = cell2mat (arrayfun (@(k) even.ene (run.t(k), run.x(k,:)', 0), 1:numel (run.t), ...
                          "UniformOutput", false));
  printf ("%-14s %18d %16.6f %26.1e %16.1e\n", way{1}, run.stats.singular_positions, ...
          run.stats.singular_times(1), max (abs (run.x(:,3) - run.x(:,1))), ...
          max (abs (e(1,:) / e(1) - 1)));
endfor
printf ("(the first change point is at t = (pi - 0.5) / 2 pi = %.6f s)\n", (pi - 0.5) / w);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, r, "out/skeleton.png", "times", [0.05 0.3 0.6], "trace", "pen", "title", ...
               "Hoeken's four-bar");
gsmbp_animate (m, r, "out/motion.gif", "speed", 0.4, "trace", "pen", "title", ...
               "Hoeken's four-bar", "width", 560);
