## The three-link PUMA 560 of Ju and Hsu (1991), each joint with its DC motor: back to the neutral
## pose in one second. Figures 10 to 12 of the paper, their numbers, a state feedback, and what the
## program itself costs; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

function t = titles (before)
  t = arrayfun (@(k) sprintf ("%s%d", before, k), 1:3, "UniformOutput", false);
endfunction

pkg load control   # before gsmbp_build: Octave calls a module slowly once its load path has changed

## ---------------------------------------------------------------- the model
m = derived_model ("puma560");
puts ("\n");
q0 = [0.5; -0.75; 0.5];
plan = gsmbp_plan ("quintic", [q0, zeros(3, 1)], [0 1]);
t = (0:0.01:1)';
planned = @(t) gsmbp_evaluate (plan, t)';

## ------------------------------------------ inverse dynamics: figures 10, 11
r = gsmbp_inverse (m, plan, t);
## the motion ends there, its jerk jumps: what holds just before
last = gsmbp_inverse (m, plan, 1, "side", -1);
r.tau(end,:) = last.tau;
r.v(end,:) = last.v;
gsmbp_csv ("out/inverse_dynamics.csv", [{"t"}, titles("q"), titles("tau"), titles("v")], ...
           [t, r.q, r.tau, r.v]);
## q1 and q3 move alike
gsmbp_plot ("out/figure_10.png", t, ...
            panel (r.q(:,1:2), {"q1 and q3", "q2"}, "joint angle [rad]"), "title", ...
            "Planned motion");
gsmbp_plot ("out/figure_11.png", t, panel (r.v, titles ("motor "), "voltage [V]"), ...
            panel (r.tau, titles ("joint "), "torque [N m]"), "title", ...
            "Voltages and torques along the motion");

puts (["inverse dynamics: torques at the joints (rotor inertia and motor friction " ...
       "in them), voltages of the motors\n"]);
printf ("%6s %10s %10s %10s %10s %10s %10s\n", "t [s]", "tau1 [N m]", "tau2", "tau3", "v1 [V]", ...
        "v2", "v3");
for k = 1:25:101
  side = {"+", " ", " ", " ", "-"}{(k + 24) / 25};
  printf ("%5.2f%s %10.4f %10.4f %10.4f %10.4f %10.4f %10.4f\n", t(k), side, ...
          1e-4 * round (1e4 * r.tau(k,:)) + 0, r.v(k,:));
endfor
printf (["torque at t = 0: %.1e, %.4f, %.4f N m: gravity passes along joint 1 and " ...
         "loads joints 2 and 3\n"], abs (r.tau(1,1)), r.tau(1,2:3));
printf (["correlation of voltage and torque: %.2f, %.2f, %.2f: not proportional; at 0.5 s the " ...
         "back-EMF is %.0f, %.0f, %.0f %% of the voltage\n\n"], ...
        corr (r.v(:,1), r.tau(:,1)), corr (r.v(:,2), r.tau(:,2)), corr (r.v(:,3), r.tau(:,3)), ...
        100 * [m.par.k1 * m.par.n1, m.par.k2 * m.par.n2, m.par.k3 * m.par.n3] ...
            .* r.u(51,:) ./ r.v(51,:));

## a septic has no jerk at its ends, so the voltage does not jump there
septic = gsmbp_plan ("septic", [q0, zeros(3, 1)], [0 1]);
s = gsmbp_inverse (m, septic, t);
hold_v = gsmbp_inverse (m, plan, [-1 2]).v;
smooth_end = gsmbp_inverse (m, septic, 1, "side", -1).v;
puts ("jump of the voltages where the motion begins and ends [V]\n");
printf ("%-8s %10s %10s %10s %12s %10s %10s %16s\n", "plan", "v1(0)", "v2(0)", "v3(0)", "v1(1)", ...
        "v2(1)", "v3(1)", "largest |v2| [V]");
printf ("%-8s %10.4f %10.4f %10.4f %12.4f %10.4f %10.4f %16.2f\n", "quintic", ...
        r.v(1,:) - hold_v(1,:), hold_v(2,:) - last.v, max (abs (r.v(:,2))));
printf ("%-8s %10.4f %10.4f %10.4f %12.4f %10.4f %10.4f %16.2f\n\n", "septic", ...
        s.v(1,:) - hold_v(1,:), hold_v(2,:) - smooth_end, max (abs (s.v(:,2))));
gsmbp_plot ("out/figure_11_septic.png", t, ...
            panel ([r.v, s.v], [titles("quintic, motor "), titles("septic, motor ")], ...
                   "voltage [V]"), "title", "Voltages: quintic and septic plan");

## ------------------------------------------------------ open loop: figure 12
x0 = r.x(1,:)';
deviation = @(r) r.x(:,1:3) - planned (r.t);
exact = gsmbp_simulate (m, x0, t, "motion", plan);
fixed = gsmbp_simulate (m, x0, t, "motion", plan, "method", "rk4", "step", 2e-3);
gsmbp_csv ("out/open_loop.csv", [{"t"}, titles("q"), titles("e")], ...
           [t, exact.x(:,1:3), deviation(exact)]);
table = @(model, n, order) gsmbp_plan ("table", linspace (0, 1, n + 1), ...
    [gsmbp_inverse(model, plan, linspace (0, 1, n + 1)(1:end-1)).v; last.v], order);

puts (["open loop: largest deviation from the planned motion [rad], the voltage " ...
       "computed anew at every step\n"]);
printf ("%-10s %12s %10s %12s %12s %12s\n", "method", "step or tol", "calls", "e1", "e2", "e3");
show = @(name, what, run) printf ("%-10s %12s %10d %12.1e %12.1e %12.1e\n", name, what, ...
                                  run.stats.calls, max (abs (deviation (run)), [], 1));
few = 0:0.25:1;
for step = [5e-3 2e-3 1e-3 5e-4]
  show ("RK4", sprintf ("%g s", step), ...
        gsmbp_simulate (m, x0, few, "motion", plan, "method", "rk4", "step", step));
endfor
for tol = 10 .^ -(2:2:12)
  show ("DOP853", sprintf ("%.0e", tol), gsmbp_simulate (m, x0, few, "motion", plan, "rtol", tol));
endfor
puts ("the same with voltages from elsewhere (DOP853, 1e-10)\n");
for n = [20 50 200]
  sampled{n} = gsmbp_simulate (m, x0, t, "input", table (m, n, 1));
  show (sprintf ("%d points", n), "linear", sampled{n});
endfor
stiff = gsmbp_set (m, "la", 1e-9);
show ("no L", "in the plan", gsmbp_simulate (m, x0, t, "input", table (stiff, 200, 3)));
puts (["(points: voltages tabulated at so many intervals; no L: computed as if " ...
       "the motors had no inductance)\n\n"]);

gsmbp_plot ("out/figure_12.png", t, panel (1e3 * deviation (sampled{20}), ...
    titles ("joint "), "deviation [mrad]", "a) voltage from a table of 20 points"), ...
            panel (1e3 * deviation (sampled{50}), titles ("joint "), "deviation [mrad]", ...
                   "b) of 50 points"), ...
            panel (1e9 * deviation (fixed), titles ("joint "), "deviation [nrad]", ...
                   "c) computed at every step (RK4, 2 ms)"), ...
            "title", ["Deviations in open loop, voltage from tables and computed at " ...
                      "every step"]);

## ------------------------------------------- a state feedback by lqr: beside the open loop
## gains at eleven times of the motion, from the exact linear model of arm and motors there; the
## voltage computed beforehand stays underneath
Q = diag ([1e5 1e5 1e5 1 1 1 0 0 0]);
design = gsmbp_lqr (m, plan, 0:0.1:1, Q, eye (3));
[A, ~] = m.jac (1, last.x', last.v');
printf (["state feedback: largest real part of the poles at the end, open loop " ...
         "%.3f/s, closed loop %.2f/s\n"], max (real (eig (A))), ...
        max (real (design.poles(:,end))));
t2 = (0:0.01:1.5)';
feed = table (m, 200, 3);
shifted = x0 + [0.05; 0.05; 0.05; zeros(6, 1)];
heavy = gsmbp_set (m, "m3", 1.2 * m.par.m3, "jx3", 1.2 * m.par.jx3, "jy3", 1.2 * m.par.jy3, ...
                   "jz3", 1.2 * m.par.jz3);
cases = {"start 0.05 rad away", m, shifted; "link 3 heavier by 20 %", heavy, x0};
printf ("%-24s %-8s %32s %32s %12s\n", "", "loop", "largest |e1|, |e2|, |e3| [rad]", ...
        "|e1|, |e2|, |e3| at 1.5 s [rad]", "max |v| [V]");
data = t2;
heads = {"t"};
for k = 1:2
  for closed = [false true]
    options = {"input", feed};
    if (closed)
      options = [options, {"gain", design.gain, "reference", design.reference}];
    endif
    run = gsmbp_simulate (cases{k,2}, cases{k,3}, t2, options{:});
    e = deviation (run);
    word = {"open", "closed"}{1 + closed};
    printf ("%-24s %-8s %12.1e %9.1e %9.1e %12.1e %9.1e %9.1e %12.1f\n", cases{k,1}, word, ...
            max (abs (e)), abs (e(end,:)), max (abs (run.v(:))));
    data = [data, e, run.v];
    heads = [heads, strcat(titles ("e"), sprintf ("_%s_%d", word, k)), ...
             strcat(titles ("v"), sprintf ("_%s_%d", word, k))];
  endfor
endfor
puts ("\n");
gsmbp_csv ("out/feedback.csv", heads, data);
names = [titles("open loop: e"), titles("feedback: e")];
gsmbp_plot ("out/feedback_figure.png", t2, panel (1e3 * data(:,[2:4 8:10]), names, ...
    "deviation [mrad]", ["a) " cases{1,1}]), panel (1e3 * data(:,[14:16 20:22]), names, ...
    "deviation [mrad]", ["b) " cases{2,1}]), ...
            "title", "Deviations: computed voltage alone, and with state feedback");

## ------------------------------------------------------ what it costs
at = gsmbp_inverse (m, plan, 0.4);
gsmbp_timing (m, 0.4, at.x', "input", at.v, "qj", at.qj);
puts ("\n");
gsmbp_workprecision (m, x0, [0 0.5 1], "motion", plan, "rk4", [5e-3 2e-3 1e-3 5e-4 1e-4], ...
                     "dp853", 10 .^ -(2:2:12), "file", "out/speed_error.png", "seconds", 0.05);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, r, "out/skeleton.png", "trace", "wrist", "title", "PUMA 560");
gsmbp_animate (m, r, "out/motion.gif", "speed", 0.5, "trace", "wrist", "title", ...
               "PUMA 560, half speed");
