## Hydraulic crane: what its valves must do for a planned motion, what comes out of it, where the
## energy goes, what happens when the valves shut, and what the load-pressure model of the cylinders
## is worth; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## From rest to rest at the columns of Q, with five derivatives zero there: the command of a
## cylinder with the spool's dynamics asks for so many.
function motion = smooth (q, times)
  pieces = numel (times) - 1;
  shape = [-252 1386 -3080 3465 -1980 462];
  coefs = zeros (rows (q), pieces, 12);
  for k = 1:pieces
    coefs(:,k,1:6) = reshape (diff (q(:,k:k+1), 1, 2) ...
                                * (shape ./ diff (times(k:k+1)) .^ (11:-1:6)), rows (q), 1, 6);
    coefs(:,k,12) = q(:,k);
  endfor
  motion = mkpp (times, coefs, rows (q));
endfunction

## lengths of the cylinders and their lever arms dl/dq (lift on theta, fold on beta) at the angles
## of Q (rows)
function [l, arm] = cylinders (q)
  turn = @(a, x, y) (x + 1i * y) * exp (1i * a);
  lift = 1i + turn (q(:,1), 1, -0.1) - (0.35 + 0.1i);
  fold = 3 + turn (q(:,2), 0.4, -0.05) - (1.7 - 0.3i);
  l = abs ([lift, fold]);
  arm = real ([lift, fold] .* conj (1i * [turn(q(:,1), 1, -0.1), turn(q(:,2), 0.4, -0.05)])) ./ l;
endfunction

## power that the balance of variant pl leaves over (share/actuators/hydraulic_cylinder.mac), both
## cylinders: volumes of the chambers, stiffness, speed
function d = defect (p, x)
  [a1, a2] = deal (3.117e-3, 2.099e-3);
  [l, arm] = cylinders (x(:,1:2));
  s = l - [0.95, 1.1];
  V1 = p.lift_vd1 + a1 * s;
  V2 = p.lift_vd2 + a2 * ([0.75, 0.6] - s);
  K = p.lift_beta * (a1^2 ./ V1 + a2^2 ./ V2);
  d = sum ((a1 * x(:,5:6) ./ K) .^ 2 .* p.lift_beta .* (a1^3 ./ V1.^2 - a2^3 ./ V2.^2) .* arm ...
             .* x(:,3:4) / 2, 2);
endfunction

## ---------------------------------------------------------------- the models
m = derived_model ("hydraulic_crane");
puts ("\n");
gsmbp_derive ("hydraulic_crane_pl.mac", "out");
short = gsmbp_build ("hydraulic_crane_pl", "directory", "out");
p = m.par;
col = @(name) find (strcmp (m.states, name));

## ------------------------------------ a cycle: lift, reach out, come back down
plan = smooth ([0.2 0.8 0.8 0.2; -1 -1.2 -0.6 -1], [0 4 7 12]);
t = linspace (0, 12, 601);
internal = [5e6; 6e6; 0; 0; 5e6; 6e6; 0; 0];   # of these the pressures on the rod sides are free
command = gsmbp_inverse (m, plan, t, "internal", internal);
[l, arm] = cylinders (command.q);
printf (["cycle of %g s: lift cylinder %.3f to %.3f m on an arm of %.3f to %.3f m, fold " ...
         "cylinder %.3f to %.3f m on %.3f to %.3f m\n"], ...
        t(end), [min(l); max(l); min(abs (arm)); max(abs (arm))]);
printf (["pressures [MPa]: lift %.2f to %.2f and %.2f to %.2f, fold %.2f to %.2f and %.2f to " ...
         "%.2f; supply %.0f\n"], ...
        [min(command.x(:,[5 6 9 10])); max(command.x(:,[5 6 9 10]))] / 1e6, p.lift_ps / 1e6);
printf ("spools within %.3f and %.3f mm; margins kept: %s\n\n", ...
        1e3 * max (abs (command.x(:,[7 11]))), {"no", "yes"}{1 + isempty (command.violations)});

puts ("the command drives the full model forward\n");
printf ("%-8s %8s %14s %14s %12s %14s %12s %12s\n", "method", "rtol", "boom [rad]", "jib [rad]", ...
        "calls", "energy audit", "seconds", "x real time");
for way = {"dp853", 1e-8; "dp853", 1e-10; "cvode", 1e-8; "cvode", 1e-10}'
  r = gsmbp_simulate (m, command.x(1,:)', t, "motion", plan, "method", way{1}, "rtol", way{2}, ...
                      "audit", 1e4);
  away = max (abs (r.x(:,1:2) - command.q));
  printf ("%-8s %8.0e %14.1e %14.1e %12d %14.1e %12.4f %12.0f\n", way{:}, away, r.stats.calls, ...
          r.audit.error, r.stats.seconds, t(end) / r.stats.seconds);
endfor
puts ("\n");
gsmbp_plot ("out/command.png", t, panel (1e3 * command.v, {"lift", "fold"}, ...
    "valve command [mm]"), ...
            panel (command.x(:,[5 6]) / 1e6, {"lift, cap side", "lift, rod side"}, ...
                            "pressure [MPa]"), ...
            panel (command.x(:,[9 10]) / 1e6, {"fold, cap side", "fold, rod side"}, ...
                   "pressure [MPa]"), "title", ["Crane: valve commands and pressures of the " ...
                                                "planned cycle"]);

## ------------------------------------------------------------------ energy
e = cell2mat (arrayfun (@(k) m.ene (r.t(k), r.x(k,:)', r.v(k,:)')(:), 1:numel (r.t), ...
                        "UniformOutput", false))';
printf ("energy of the cycle: supplied %.2f kJ, lost %.2f kJ\n", trapz (t, e(:,4:5)) / 1e3);
printf (["most mechanical energy that it holds: %.3f kJ above the start; valves and " ...
         "leaks take the rest\n\n"], (max (e(:,1) + e(:,2)) - e(1,1) - e(1,2)) / 1e3);
gsmbp_plot ("out/energy.png", r.t, panel (e(:,4:5) / 1e3, {"supplied", "lost"}, ...
    "power [kW]"), panel ([e(:,1), e(:,2) - e(1,2)] / 1e3, {"kinetic", "potential"}, ...
                          "energy [kJ]"), ...
            "title", "Crane: power from the supply and energy of the linkage");

## --------------------------------------------- hydraulic frequencies, at rest
x = command.x(1,:)';
T = @(u) m.ene (0, [x(1:2); u; x(5:end)], [0; 0])(1);
mixed = T ([1; 1]) - T ([1; 0]) - T ([0; 1]);
M = [2*T([1; 0]), mixed; mixed, 2*T([0; 1])];
[l, arm] = cylinders (x(1:2)');
spring = @(c, s) p.lift_beta ...
    * (3.117e-3 ^ 2 / (p.lift_vd1 + 3.117e-3 * s) ...
         + 2.099e-3 ^ 2 / (p.lift_vd2 + 2.099e-3 * (c - s)));
K = diag ([spring(0.75, l(1) - 0.95), spring(0.6, l(2) - 1.1)] .* arm .^ 2);
wanted = sqrt (sort (eig (K, M)));
A = m.jac (0, x, command.v(1,:)');
poles = eig (A);
found = sort (abs (poles(imag (poles) > 1 & abs (poles) < 400)));
printf (["hydraulic frequencies at the start [rad/s]: %.3f, %.3f; by the stiffness " ...
         "of the oil alone %.3f, %.3f\n"], found(1:2), wanted);
printf ("(spools: %.0f rad/s, damping ratio %.1f)\n\n", p.lift_om, p.lift_dv);

## -------------------------------------------- valves shut while it comes down
at = t(find (t > 7 & command.u(:,1)' < -0.05, 1));
half = gsmbp_simulate (m, command.x(1,:)', [0 at], "motion", plan, "method", "cvode", "rtol", ...
                       1e-10).x(end,:)';
s = linspace (0, 1.5, 751);
full = gsmbp_simulate (m, half, s, "input", [0; 0], "method", "cvode", "rtol", 1e-10);
half_short = [half(1:4); half(5) - half(6) * 2.099 / 3.117; half(9) - half(10) * 2.099 / 3.117];
less = gsmbp_simulate (short, half_short, s, "input", [0; 0], "method", "cvode", "rtol", 1e-10);
force = @(x, k) x(:,k) - x(:,k+1) * 2.099 / 3.117;
printf (["valves shut at %.3f s, the boom coming down at %.3f rad/s: load pressure of the lift " ...
         "swings between %.2f and %.2f MPa; cap side up to %.2f, rod side down to %.2f MPa\n"], ...
        at, half(3), [min(force (full.x, 5)), max(force (full.x, 5)), max(full.x(:,5)), ...
                      min(full.x(:,6))] / 1e6);
gsmbp_plot ("out/shut.png", s, panel (full.x(:,[5 6]) / 1e6, ...
                                      {"lift, cap side", "lift, rod side"}, "pressure [MPa]"), ...
            panel ([force(full.x, 5), less.x(:,5)] / 1e6, {"full model", "variant pl"}, ...
                   "load pressure [MPa]"), ...
            "title", "Crane: the valves shut while the load comes down");

## ------------------------------------------------ what the short model is worth
puts ("\nload-pressure model (one state a cylinder, no spool)\n");
own = gsmbp_inverse (short, plan, t);
r = gsmbp_simulate (short, own.x(1,:)', t, "motion", plan, "method", "cvode", "rtol", 1e-10, ...
                    "audit", 1e4);
printf (["under its own command: at most %.1e rad from the plan, %d calls in %.4f " "s\n"], ...
        max (max (abs (r.x(:,1:2) - own.q))), r.stats.calls, r.stats.seconds);
left = cumtrapz (t', defect (p, r.x));
printf (["energy audit: up to %.3f J left over of %.0f kJ that passed, %.1e of it; the entry's " ...
         "formula for what its balance leaves over gives %.3f J (apart at most %.1e J)\n"], ...
        max (abs (r.audit.balance)), r.audit.passed(end) / 1e3, r.audit.error, max (abs (left)), ...
            max (abs (left ...
                - r.audit.balance)));
full = gsmbp_simulate (m, command.x(1,:)', t, "input", gsmbp_plan ("table", t, own.v, 3), ...
                       "method", "cvode", "rtol", 1e-9);
away = max (abs (full.x(:,1:2) - command.q));
printf (["its command drives the full model %.2e rad (boom) and %.2e rad (jib) away " ...
         "from the plan: %.1e and %.1e of their way\n"], away, away ./ range (command.q));
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, command, "out/skeleton.png", "centres", false, "title", "Loader crane");
gsmbp_animate (m, command, "out/motion.gif", "times", t(1:6:end), "fps", 12, "centres", false, ...
               "title", "Loader crane", "width", 520);
