## Bricard's orthogonal six-bar falls for ten seconds: five equations for its loop of which four are
## independent; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## the hinges (3 x 6) for the angle q1: the odd angles are equal, the even ones fulfil sin q1 + sin
## q2 + sin q1 sin q2 = 0
function P = hinges (q1)
  q2 = -asin (sin (q1) / (1 + sin (q1)));
  turn = struct ("x", @(a) [1 0 0; 0 cos(a) -sin(a); 0 sin(a) cos(a)], "y", ...
                 @(a) [cos(a) 0 sin(a); 0 1 0; -sin(a) 0 cos(a)], "z", ...
                 @(a) [cos(a) -sin(a) 0; sin(a) cos(a) 0; 0 0 1]);
  rods = [1 0 0; 0 -1 0; 0 0 1; -1 0 0; 0 1 0]';
  R = eye (3);
  P = zeros (3, 6);
  for k = 1:5
    R *= turn.("yzxyz"(k)) ({q2, q1}{1 + mod(k, 2)});
    P(:,k+1) = P(:,k) + R * rods(:,k);
  endfor
endfunction

## kinetic energy is J/2*(rate of q1)^2, of a uniform rod m/6*(va^2 + va*vb + vb^2) with the speeds
## of its ends; V: potential energy. g = 9.81, 1 m, 1 kg
function [J, V] = by_hand (q1)
  v = imag (hinges (q1 + 1e-30i)) / 1e-30;
  [va, vb] = deal (v(:,1:5), v(:,2:6));
  J = sum (sum (va.^2 + va .* vb + vb.^2)) / 3;
  y = real (hinges (q1))(2,:);
  V = 9.81 * sum (y(1:5) + y(2:6)) / 2;
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("bricard");
x0 = m.initial;
gsmbp_mobility (m, x0);
puts ("\n");

## --------------------------------------------------------------- ten seconds
t = (0:0.01:10)';
energies = @(run) cell2mat (arrayfun (@(k) m.ene (run.t(k), run.x(k,:)'), 1:numel (run.t), ...
                                      "UniformOutput", false))';
worst = @(e) max (abs (sum (e(:,1:3), 2) - sum (e(1,1:3)))) / range (e(:,2));
puts ("10 s from rest in the cube's edges, by the six ways (DOP853)\n");
printf ("%-14s %8s %20s %12s %16s %10s %12s %16s\n", "way", "rtol", "energy [J/J]", "|phi| [m]", ...
        "|phidot| [m/s]", "calls", "ms for 1 s", "q1(10 s) [rad]");
for rtol = [1e-6 1e-9 1e-12]
  for way = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"}
    simulate = @() gsmbp_simulate (m, x0, 0:0.25:10, "loops", way{1}, "rtol", rtol);
    run = simulate ();
    s = run.stats;
    seconds = min (arrayfun (@(k) simulate ().stats.seconds, 1:100));
    printf ("%-14s %8.0e %20.1e %12.1e %16.1e %10d %12.3f %16.9f\n", way{1}, rtol, ...
            worst (energies (run)), s.drift.phi, s.drift.phidot, s.calls, 100 * seconds, ...
            run.x(end,1));
  endfor
endfor
puts (["(energy: largest change of the total, over the potential energy " ...
       "exchanged; time: the shortest of 100 runs)\n"]);

r = gsmbp_simulate (m, x0, t);
e = energies (r);
small = zeros (numel (t), 5);
for k = 1:numel (t)
  [~, ~, H] = m.con (t(k), r.x(k,1:5)');
  small(k,:) = svd (H)';
endfor
printf (["singular values of the constraints over the whole run: the fourth at " ...
         "least %.3f, the fifth at most %.0e: rank 4 everywhere\n"], min (small(:,4)), ...
        max (small(:,5)));
printf ("potential energy exchanged: %.3f J; largest speed of a joint: %.3f rad/s\n", ...
        range (e(:,2)), max (max (abs (r.x(:,6:10)))));

## --------------------------------------------------- one freedom, by hand
wrong = [r.x(:,3) - r.x(:,1), r.x(:,5) - r.x(:,1), r.x(:,4) - r.x(:,2), ...
         sin(r.x(:,1)) + sin(r.x(:,2)) + sin(r.x(:,1)) .* sin(r.x(:,2))];
printf (["\nq1 = q3 = q5, q2 = q4 and sin q1 + sin q2 + sin q1 sin q2 = 0: within " ...
         "%.1e along the run\n"], max (max (abs (wrong))));
miss = zeros (numel (t), 2);
[~, V0] = by_hand (0);
for k = 1:numel (t)
  [J, V] = by_hand (r.x(k,1));
  miss(k,:) = [e(k,1) + V - V0, J * r.x(k,6)^2 / 2 - e(k,1)];
endfor
printf (["energies of the one freedom by hand, largest differences: %.1e J (kinetic " ...
         "+ potential), %.1e J (kinetic)\n"], max (abs (miss)));

## half a period, from the cube's edges to the other rest at q1 = pi: integral of dq/sqrt(2 (V0 -
## V)/J), q1 = pi (1 - cos s)/2, by midpoints
n = 4000;
s = ((1:n) - 0.5) * pi / n;
half = 0;
for k = 1:n
  [J, V] = by_hand (pi * (1 - cos (s(k))) / 2);
  half += pi / 2 * sin (s(k)) * sqrt (J / (2 * (V0 - V))) * pi / n;
endfor
near = find (r.t > 2 & r.x(:,6) <= 0, 1);
fine = gsmbp_simulate (m, r.x(near-1,:)', r.t(near-1) + (0:1e-4:0.02));
rest = interp1 (fine.x(:,6), fine.t, 0, "spline");
printf ("at rest again after %.9f s (q1 = %.9f); by quadrature %.9f s\n", rest, ...
        interp1 (fine.t, fine.x(:,1), rest, "spline"), half);
diary off

gsmbp_plot ("out/angles.png", t, panel (r.x(:,1:2), {"q1 = q3 = q5", "q2 = q4"}, ...
    "angle [rad]"), panel ([e(:,1), e(:,2) - e(1,2), sum(e(:,1:3), 2) - e(1,2)], ...
                           {"kinetic", "potential", "sum"}, "energy above the start [J]"), ...
            "title", "Bricard's six-bar: angles and energy");
change = abs (sum (e(:,1:3), 2) - sum (e(1,1:3))) / range (e(:,2));
gap = cell2mat (arrayfun (@(k) norm (m.con (0, r.x(k,1:5)'), Inf), 1:numel (t), "UniformOutput", ...
                          false))';
gsmbp_plot ("out/drift.png", t, ...
            panel (max (change, 1e-18), {"energy"}, "relative change of energy [1]"), ...
            panel (max (gap, 1e-18), {"loop"}, "gap of the loop [m]"), "title", ...
            "Bricard's six-bar: drift over 10 s", "scale", "semilogy");

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, r, "out/skeleton.png", "times", [0 0.7 1.4], "up", "y", "title", ...
               "Bricard's six-bar");
gsmbp_animate (m, r, "out/motion.gif", "times", 0:0.05:5, "fps", 20, "up", "y", "title", ...
               "Bricard's six-bar", "width", 480);
