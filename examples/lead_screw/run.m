## Lead screw: a DC motor lifts a table by a screw. What the motor feels of the table, what the
## thread loses, a feed motion by voltage, and what happens when the power is off, for four screws;
## everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## integral of equidistant samples (an odd number) by Simpson's rule
function s = simpson (y, h)
  s = h / 3 * (y(1,:) + 4 * sum (y(2:2:end-1,:), 1) + 2 * sum (y(3:2:end-2,:), 1) + y(end,:));
endfunction

pkg load control   # before gsmbp_build: Octave calls a module slowly once its load path has changed

## ---------------------------------------------------------------- the model
cpu = gsmbp_derive ("lead_screw.mac");
printf ("derivation: %.1f s of processor time, Maxima's start included\n", cpu);
m = gsmbp_build ("lead_screw");
printf (["%d of the five rows of the thread removed (the guide does their work); " ...
         "Gruebler's count %d, true mobility %d\n\n"], numel (m.removed), m.mobility.gruebler, ...
        m.mobility.true);
screws = {"ball, 5 mm", 5e-3, 0.005; "ball, 20 mm", 20e-3, 0.005; "trapezoidal, 5 mm", 5e-3, ...
          0.12; "trapezoidal, 20 mm", 20e-3, 0.12};
for k = 1:rows (screws)
  model{k} = gsmbp_set (m, "lead", screws{k,2}, "mu", screws{k,3});
endfor

## ------------------------------------------------ what the motor feels, and what the thread loses
## inertia: acceleration of the screw by one ampere more; efficiency: weight lifted slowly, by the
## torque that the inverse model wants at the screw
puts ("inertia at the screw [kg m^2], and efficiency of the thread while it lifts slowly\n");
printf ("%-20s %10s %10s %10s %10s %12s %12s %10s %12s\n", "screw", "rotor", "screw", "table", ...
        "sum", "of the model", "deviation", "thread", "deviation");
for k = 1:rows (screws)
  p = model{k}.par;
  pitch = p.lead / (2 * pi);
  parts = [p.n ^ 2 * p.jm, p.js, p.mt * pitch ^ 2];
  at = [0; 0; 0; 0; 0];
  felt = p.n * p.km / (model{k}.rhs (0, at + [0; 0; 0; 0; 1], 0)(3) - model{k}.rhs (0, at, 0)(3));
  slow = 20;   # rad/s: the smooth friction law is at its limit there
  bare = gsmbp_set (model{k}, "cb", 0, "cg", 0, "bm", 0);
  tau = gsmbp_inverse (bare, gsmbp_plan ("profile", mkpp ([0 1], slow), 1, 0), 0.5).tau;
  efficiency = p.mt * p.g * pitch / tau;
  limit = pitch / (pitch + p.mu * p.r * slow / hypot (slow, p.w0));
  printf ("%-20s %10.3e %10.3e %10.3e %10.3e %12.3e %12.1e %8.1f %% %12.1e\n", screws{k, ...
      1}, parts, sum (parts), felt, abs (felt / sum (parts) - 1), 100 * efficiency, ...
          abs (efficiency / limit - 1));
endfor
puts ("(closed forms: n^2 jm + js + mt (lead/2 pi)^2; lead/2 pi beside lead/2 pi + mu r)\n\n");

## ----------------------------------------------------- a feed motion: 100 turns
## the voltage comes from the inverse model through motor, belt, thread and guide
lift = 0.5;
duration = 2.5;
plan = gsmbp_plan ("septic", [0, lift / (m.par.lead / (2 * pi))], [0 duration]);
n = 5000;
t = linspace (0, duration, n + 1)';
r = gsmbp_inverse (m, plan, t);
r.v(end) = gsmbp_inverse (m, plan, duration, "side", -1).v;
p = m.par;
pitch = p.lead / (2 * pi);
i = r.x(:,5);
w = r.u(:,1);
fr = p.mu * p.r * p.mt * p.g * w ./ hypot (w, p.w0);
bill = simpson ([r.v .* i, p.ra * i .^ 2, p.bm * (p.n * w) .^ 2, p.cb * w .^ 2, fr .* w, ...
                 p.cg * (pitch * w) .^ 2, p.mt * p.g * pitch * w], duration / n);
printf (["%g turns lift the table by %g m in %g s: voltage up to %.1f V, current up to %.1f A, " ...
         "power up to %.0f W\n"], r.q(end, ...
    1) / (2 * pi), r.q(end,2), duration, max (r.v), ...
        max (i), max (r.v .* i));
names = {"electrical energy", "copper", "motor's friction", "bearing", "thread", "guide", ...
         "weight lifted"};
for k = 1:numel (names)
  printf ("%20s %10.4f J %8.2f %%\n", names{k}, bill(k), 100 * bill(k) / bill(1));
endfor
printf ("%20s %10.1e J (the move begins and ends at rest)\n\n", "not found", ...
        abs (bill(1) - sum (bill(2:end)) - p.la / 2 * (i(end) ^ 2 - i(1) ^ 2)));
gsmbp_plot ("out/figure_motion.png", t, panel (1e3 * r.q(:,2), {"table"}, ...
    "height [mm]"), panel (r.v, {"voltage"}, "voltage [V]"), panel (i, {"current"}, ...
    "current [A]"), ...
            "title", "100 turns: planned motion and what it takes");

## reactions: the thread carries the weight, the guide the moment of a table whose mass centre
## stands off
k = round (n / 4) + 1;
y = m.out (t(k), r.x(k,:)', r.v(k));
a = r.ud(k,2);
printf (["at t = %.3f s the thread carries %.4f N = m (g + a) + c v = %.4f N, the guide a " ...
         "moment of %.4f N m = m (g + a) e - c v |a| = %.4f N m\n\n"], t(k), ...
        y(strcmp (m.outputs, "thread.z")), p.mt * (p.g + a) + p.cg ...
            * r.u(k,2), abs (y(strcmp (m.outputs, "guide.my"))), p.mt * (p.g + a) * p.e - p.cg ...
            * r.u(k,2) * abs (p.a));

## ------------------------------------- position by voltage: state feedback on top
## the exact linear model in the independent states: angle, speed, current; lqr; the table 20 %
## heavier than the controller knows and the friction doubled
hold = r.x(end,:)';
[sys, T, independent] = gsmbp_linear (m, 0, hold, r.v(end), "reduced", "theta");
J = p.n ^ 2 * p.jm + p.js + p.mt * pitch ^ 2;
B = p.n ^ 2 * p.bm + p.cb + p.cg * pitch ^ 2 + p.mu * p.r * p.mt * p.g / p.w0;
closed = [0, 1, 0; 0, -B / J, p.n * p.km / J; 0, -p.n * p.km / p.la, -p.ra / p.la];
printf (["linear model at the top, states %s: deviation from closed form %.1e of " ...
         "its largest entry\n"], strjoin (m.states(independent), ", "), ...
        max (abs (sys.a - closed)(:)) / max (abs (closed(:))));
[K3, ~, poles] = lqr (sys.a, sys.b, diag ([100 0 0]), 0.1);
K = zeros (1, 5);
K(independent) = K3;
fine = linspace (0, duration, 401)';
reference = gsmbp_plan ("table", [fine; duration + 1], [gsmbp_inverse(m, plan, fine).x; hold'], 1);
feed = gsmbp_plan ("table", [t(1:10:end); duration + 1], [r.v(1:10:end); r.v(end)], 1);
worse = gsmbp_set (m, "mt", 1.2 * p.mt, "mu", 2 * p.mu, "cg", 2 * p.cg);
t2 = (0:0.01:duration + 1)';
printf ("poles with feedback: %s 1/s\n", ...
        strjoin (arrayfun (@(x) num2str (x, "%.1f"), poles', "UniformOutput", false), ", "));
printf ("%-34s %24s %20s\n", "", "largest deviation [mm]", "at the end [mm]");
cases = {"nominal, voltage alone", m, false; "heavier, rougher; voltage alone", worse, false; ...
         "heavier, rougher; with feedback", worse, true};
for k = 1:rows (cases)
  options = {};
  if (cases{k,3})
    options = {"gain", K, "reference", reference};
  endif
  run{k} = gsmbp_simulate (cases{k,2}, r.x(1,:), t2, "input", feed, options{:});
  e(:,k) = 1e3 * (run{k}.x(:,2) - pitch * gsmbp_evaluate (plan, min (t2, duration))');
  printf ("%-34s %24.4f %20.4f\n", cases{k,1}, max (abs (e(:,k))), e(end,k));
endfor
puts ("\n");
gsmbp_plot ("out/figure_feedback.png", t2, panel (e(:,2), {"voltage alone"}, "deviation [mm]"), ...
            panel (1e3 * e(:,3), {"with feedback"}, "deviation [um]"), "title", ...
            "Table 20 % heavier, friction doubled");

## ------------------------------------------------------------ the power is off
## motor short-circuited (0 V) at the top: a coarse ball screw runs down, a fine trapezoidal one
## holds
t3 = (0:0.002:1)';
puts ("0 V at the motor: what the table does\n");
printf ("%-20s %26s %26s %12s\n", "screw", "speed after 1 s [mm/s]", "closed form [mm/s]", ...
        "gap [m]");
for k = 1:rows (screws)
  drop = gsmbp_simulate (model{k}, [0 0 0 0 0], t3, "input", 0);
  fall(:,k) = 1e3 * drop.x(:,2);
  p = model{k}.par;
  pitch = p.lead / (2 * pi);
  c = p.n ^ 2 * (p.bm + p.km ^ 2 / p.ra) + p.cb + p.cg * pitch ^ 2;
  balance = @(w) p.mt * p.g * pitch - c * w - p.mu * p.r * p.mt * p.g * w ./ hypot (w, p.w0);
  steady = fzero (balance, [0, p.mt * p.g * pitch / c]);
  printf ("%-20s %26.6f %26.6f %12.1e\n", screws{k,1}, -1e3 * drop.x(end,4), ...
          1e3 * pitch * steady, drop.stats.drift.phi);
endfor
puts (["(mu r above lead/2 pi holds; the smooth friction law lets it creep where " ...
       "a real one sticks)\n\n"]);
gsmbp_plot ("out/figure_power_off.png", t3, panel (fall, screws(:,1)', "height [mm]"), "title", ...
            "Power off, motor short-circuited");

## ----------------------------------------------------------------- many turns
long = gsmbp_simulate (m, r.x(1,:), [0 60 120], "input", 24);
turns = long.x(end,1) / (2 * pi);
printf ("24 V for 120 s: %.1f turns; height less turns*lead %.1e m of %.2f m\n", turns, ...
        abs (long.x(end,2) - turns * m.par.lead), long.x(end,2));
s = gsmbp_timing (m, 0, r.x(100,:), "input", r.v(100), "print", false);
printf ("one call of the right-hand side: %.0f ns\n", 1e9 * s.rhs);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, r, "out/skeleton.png", "title", "Lead screw");
## the lead is drawn twelve times as long as it is, so that it can be seen turning
shown = 12 * m.par.lead / (2 * pi);
radius = 0.02;
z = linspace (0, m.par.h, 400);
rod = [0, 0; 0, 0; 0, m.par.h];
rail = [m.par.a * [1, 1]; 0, 0; 0, m.par.h];
box = [-0.06 0.06 0.06 -0.06 -0.06; -0.06 -0.06 0.06 0.06 -0.06];
box = [box(1,:) * 2.2 + 0.06; box(2,:) * 1.5];
table = [box; -0.02 * ones(1, 5)];
table = [table, NaN(3, 1), [box; 0.02 * ones(1, 5)]];
for k = 1:4
  table = [table, NaN(3, 1), [box(:,k); -0.02], [box(:,k); 0.02]];
endfor
arm = [m.par.a, box(1,1); 0, 0; 0, 0];
steps = 60;
for k = 1:steps
  at = 1 + round (n * (k - 1) / (steps - 1));
  angle = -r.q(at,1) / 12;
  height = 0.1 + r.q(at,2);
  thread = [radius * cos(z / shown + angle); radius * sin(z / shown + angle); z];
  up = [0; 0; height];
  frames{k} = ...
      {rail, "lines lw 5 lc rgb '#888888'", "guide"; rod, "lines lw 2 lc rgb '#00459a'", ""; ...
       thread, "lines lw 1.5 lc rgb '#00459a'", "screw"
               table + up, "lines lw 2.5 lc rgb '#cc3318'", "table"; arm ...
                   + up, "lines lw 5 lc rgb '#cc3318'", ""};
  titles{k} = sprintf ("t = %.2f s, %.0f turns", t(at), r.q(at,1) / (2 * pi));
endfor
film ("out/motion.gif", frames, "view", [30, 20], "width", 330, "titles", titles);
