## Cardan's transmission: two shafts at an angle, a universal joint between them; then two universal
## joints, and when they undo each other. Ratio, moments in the joint, a run-up on the motor; four
## ways to mount a shaft with two joints; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## a shaft in ground axes: from the point `from` of its axis to `to` (link axes), a fork of half
## width r at each joint: [x of the joint, direction of the arms]
function p = shaft (origin, R, from, to, joints, r, reach)
  p = [from, to; 0, 0; 0, 0];
  for k = 1:columns (joints)
    arm = joints(2:4,k);
    back = [joints(1,k) + sign((from + to) / 2 - joints(1,k)) * reach; 0; 0];
    tip = [joints(1,k); 0; 0];
    p = [p, NaN(3, 1), tip + r * arm, back + r * arm, back - r * arm, tip - r * arm];
  endfor
  p = origin + R * p;
endfunction

function R = turn (axis, angle)
  c = cos (angle);
  s = sin (angle);
  R = struct ("x", [1, 0, 0; 0, c, -s; 0, s, c], "y", [c, 0, s; 0, 1, 0; -s, 0, c], "z", ...
              [c, -s, 0; s, c, 0; 0, 0, 1]).(axis);
endfunction

## --------------------------------------------------------------- the models
degree = pi / 180;
cpu = gsmbp_derive ("hooke.mac");
cpu2 = gsmbp_derive ("hooke_double.mac", "out");
printf (["derivation: %.1f s of processor time; with two joints %.1f s; Maxima's " ...
         "start included\n"], cpu, cpu2);
m = gsmbp_build ("hooke");
double_shaft = gsmbp_build ("hooke_double", "directory", "out");
printf (["one joint:  %d of its four rows removed; Gruebler's count %d, true " "mobility %d\n"], ...
        numel (m.removed), m.mobility.gruebler, m.mobility.true);
printf (["two joints: %d rows, the motion that drives included; their rank %d; Gruebler's " ...
         "count %d, true mobility %d\n\n"], double_shaft.mobility.rows, ...
        double_shaft.mobility.rank, double_shaft.mobility.gruebler, double_shaft.mobility.true);

## -------------------------------------------------------- ratio of the speeds
omega = 20;
turn_time = 2 * pi / omega;
t = linspace (0, turn_time, 361)';
theta = omega * t;
plan = gsmbp_plan ("profile", mkpp ([0 turn_time], omega), 1, 0);
closed = @(b) cos (b) ./ (1 - sin (theta) .^ 2 * sin (b) ^ 2);
angles = [10 20 30 45];
puts ("speed of the driven shaft by that of the driver over one turn\n");
printf ("%10s %10s %10s %28s\n", "angle", "least", "largest", "deviation from closed form");
for k = 1:numel (angles)
  b = angles(k) * degree;
  r = gsmbp_inverse (gsmbp_set (m, "b", b), plan, t);
  ratio(:,k) = r.u(:,2) ./ r.u(:,1);
  printf ("%7d deg %10.6f %10.6f %28.1e\n", angles(k), min (ratio(:,k)), max (ratio(:,k)), ...
          max (abs (ratio(:,k) - closed (b))));
endfor
puts (["(closed form: cos b / (1 - sin^2 theta sin^2 b), so the extremes are cos " ...
       "b and 1/cos b)\n\n"]);
names = arrayfun (@(a) sprintf ("%d degrees", a), angles, "UniformOutput", false);
gsmbp_plot ("out/figure_ratio.png", theta / degree, panel (ratio, names, ...
    "speed ratio [1]"), "title", "Ratio of the speeds over one turn of the driver", ...
            "xlabel", "angle of the driver [degrees]", "head", "angle");

## ------------------------------------------------- moments: what the cross carries
## the driver turns evenly; load, friction and the flywheel's inertia decide what the driven shaft
## needs
b = m.par.b;
r = gsmbp_inverse (m, plan, t);
y = cell2mat (arrayfun (@(k) m.out (t(k), r.x(k,:)', r.v(k)), 1:numel (t), "UniformOutput", ...
                        false))';
rate = closed (b);
needed = m.par.j2 * omega ^ 2 * rate .^ 2 * sin (b) ^ 2 / cos (b) .* sin (2 * theta) + m.par.c ...
    * omega * rate + m.par.tl;
expected = [needed .* rate, needed .* rate .* tan(b) .* cos(theta), needed, ...
            needed .* sin(b) .* sin(theta) ./ sqrt(1 - sin(theta) .^ 2 * sin(b) ^ 2)];
printf (["moments that the joint passes on, driver at %g rad/s, shafts at 30 " ...
         "degrees [N m]\n"], omega);
printf ("%14s %14s %14s %14s %14s\n", "driver [deg]", "on driver", "bending it", "on driven", ...
        "bending it");
for k = 1:45:361
  printf ("%14.0f %14.6f %14.6f %14.6f %14.6f\n", theta(k) / degree, ...
          1e-9 * round (1e9 * y(k,:)) + 0);
endfor
printf (["deviation from the closed form: %.1e N m; largest bending by the driver's mean " ...
         "torque: %.2f; voltage of the motor %.1f to %.1f V\n\n"], ...
        max (abs ((y - expected)(:))), max (abs (y(:,2))) / mean (y(:,1)), min (r.v), max (r.v));
gsmbp_plot ("out/figure_moments.png", theta / degree, panel (y(:,[1 3]), {"driver", "driven"}, ...
    "torque along shaft [N m]"), panel (y(:,[2 4]), {"driver", "driven"}, ...
            "bending moment [N m]"), ...
            "title", "Moments at the cross, driver at 20 rad/s", "xlabel", ...
                "angle of the driver [degrees]", "head", "angle");

## --------------------------------------------------------- run-up on 16 V
t = (0:2e-3:1.5)';
run = gsmbp_simulate (m, m.initial, t, "input", 16);
e = cell2mat (arrayfun (@(k) m.ene (t(k), run.x(k,:)', 16), 1:numel (t), "UniformOutput", false))';
fine = gsmbp_simulate (m, m.initial, (0:1e-4:1.5)', "input", 16);
power = cell2mat (arrayfun (@(k) m.ene (fine.t(k), fine.x(k,:)', 16)(4:5), 1:numel (fine.t), ...
                            "UniformOutput", false))';
weights = [1, repmat([4 2], 1, (numel (fine.t) - 3) / 2), 4, 1] * 1e-4 / 3;
miss = sum (e(end,1:3)) - sum (e(1,1:3)) - weights * (power(:,1) - power(:,2));
late = run.t > 1;
printf (["run-up on 16 V: after 1 s the driver turns at %.2f to %.2f rad/s, the driven shaft " ...
         "at %.2f to %.2f rad/s; current %.1f to %.1f A\n"], ...
        min (run.x(late,3)), max (run.x(late,3)), min (run.x(late,4)), max (run.x(late, ...
              4)), min (run.x(late,5)), max (run.x(late,5)));
printf (["over %.1f turns: gap of the loop %.1e, energy put in and not found %.1e " ...
         "of %.0f J\n\n"], run.x(end,1) / (2 * pi), run.stats.drift.phi, abs (miss), ...
        weights * power(:,1));
gsmbp_plot ("out/figure_runup.png", t, panel (run.x(:,3:4), {"driver", "driven"}, ...
    "speed [rad/s]"), panel (run.x(:,5), {"current"}, "current [A]"), ...
            "title", "Run-up on 16 V, shafts at 30 degrees");

## ------------------------------------------------------ two universal joints
## the driver is driven evenly (motion = omega*t), so the multiplier of that row is the torque that
## it takes
t = linspace (0, turn_time, 361)';
arrangements = {"W: bends 30, 30", 30, 30, 0; "Z: bends 30, -30", 30, -30, 0; "bends 30, 15", ...
                30, 15, 0; "fork turned by 90", 30, 30, 90};
puts ("two joints: speed of the driven shaft by that of the driver, torque at the driver\n");
printf ("%-20s %10s %10s %14s %14s %18s\n", "", "least", "largest", "closed form", "deviation", ...
        "torque [N m]");
gain = [1, 1, cosd(30) / cosd(15), cosd(30) ^ 2];   # tan psi = gain * tan theta
for k = 1:rows (arrangements)
  d = gsmbp_set (double_shaft, "b1", arrangements{k,2} * degree, "b2", ...
                 arrangements{k,3} * degree, "w", arrangements{k,4} * degree);
  x0 = gsmbp_assemble (d, [0 0 0 0 omega 0 0 0], "hold", "theta");
  two{k} = gsmbp_simulate (d, x0, t);
  ratios(:,k) = two{k}.x(:,8) / omega;
  expected = gain(k) ./ (cos (theta) .^ 2 + gain(k) ^ 2 * sin (theta) .^ 2);
  for i = 1:numel (t)
    [~, lam, ~] = d.acc (t(i), two{k}.x(i,:)');
    torque(i,k) = lam(5);
  endfor
  printf ("%-20s %10.6f %10.6f %14.6f %14.1e %8.2f to %6.2f\n", arrangements{k, ...
      1}, min (ratios(:,k)), max (ratios(:,k)), max (expected), max (abs (ratios(:,k) ...
          - expected)), ...
          min (torque(:,k)), max (torque(:,k)));
endfor
puts (["(the middle shaft still turns unevenly: that torque is left even where " ...
       "the ends turn as one; there is no load)\n"]);
names = {"W and Z, bends 30 degrees", "bends 30 and 15 degrees", ...
         "fork turned by 90 degrees"};
gsmbp_plot ("out/figure_double.png", theta / degree, panel (ratios(:,2:4), names, ...
    "speed ratio [1]"), panel (torque(:,2:4), names, "torque at driver [N m]"), ...
            "title", "Two universal joints", "xlabel", "angle of the driver [degrees]", "head", ...
                "angle");

s = gsmbp_timing (m, 0, run.x(end,:), "input", 16, "print", false);
s2 = gsmbp_timing (double_shaft, 0, two{1}.x(end,:), "print", false);
printf (["one call of the right-hand side: %.0f ns; with two joints %.0f ns " ...
         "(redundant rows: solved densely)\n"], 1e9 * s.rhs, 1e9 * s2.rhs);
diary off

## ------------------------------------------------------ what it looks like
gsmbp_animate (m, run, "out/skeleton.png", "title", "Hooke's joint", "times", 1.5);
steps = 60;
[r, reach] = deal (0.045, 0.05);
colors = {"#00459a", "#cc3318", "#1a7f37"};
style = @(k) sprintf ("lines lw 4 lc rgb '%s'", colors{k});
tilt = turn ("z", pi / 6);
rim = [0.12 * ones(1, 41); 0.06 * cos(linspace (0, 2 * pi, 41)); ...
       0.06 * sin(linspace (0, 2 * pi, 41))];
rim = [rim, NaN(3, 1), [0.12; 0.06; 0], [0.12; -0.06; 0], NaN(3, 1), [0.12; 0; 0.06], ...
       [0.12; 0; -0.06]];
for k = 1:steps
  at = 2 * pi * (k - 1) / steps;
  R1 = turn ("x", at);
  R2 = tilt * turn ("x", atan2 (cos (pi / 6) * sin (at), cos (at)));
  cross = [r * R1(:,3), -r * R1(:,3), NaN(3, 1), r * R2(:,2), -r * R2(:,2)];
  frames{k} = {shaft([0; 0; 0], R1, -0.2, -reach, [0; 0; 0; 1], r, ...
                     reach), style(1), "driver"; shaft([0; 0; 0], R2, reach, 0.2, [0; 0; 1; 0], ...
      r, reach), style(2), "driven"
               R2 ...
                   * rim, "lines lw 2 lc rgb '#cc3318'", ""; cross, ...
                       "lines lw 3 lc rgb '#222222'", "cross"};
endfor
film ("out/motion.gif", frames, "view", [-20, 30], "axis", 0.05);
## the shaft with two joints in W, one turn, from the simulated coordinates
l = double_shaft.par;
for k = 1:steps
  q = two{1}.x(1 + round (360 * (k - 1) / steps),1:4);
  R1 = turn ("x", q(1));
  R2 = R1 * tilt * turn ("z", q(2)) * turn ("y", q(3));
  R3 = tilt * tilt * turn ("x", q(4));
  far = tilt * [l.l2; 0; 0];
  cross = [r * R1(:,3), -r * R1(:,3), NaN(3, 1), r * R2(:,2), -r * R2(:,2)];
  cross = [cross, NaN(3, 1), far + r * R2(:,2), far - r * R2(:,2), NaN(3, 1), far + r * R3(:,3), ...
           far - r * R3(:,3)];
  frames{k} = {shaft([0; 0; 0], R1, -0.2, -reach, [0; 0; 0; 1], r, reach), style(1), "driver"
               shaft([0; 0; 0], R2, reach, l.l2 - reach, [0, l.l2; 0, 0; 1, 1; 0, 0], r, ...
                     reach), style(3), "middle"
               shaft(far, R3, reach, 0.2, [0; 0; 0; 1], r, reach), style(2), "driven"; far + R3 ...
                   * rim, "lines lw 2 lc rgb '#cc3318'", ""; cross, ...
                       "lines lw 3 lc rgb '#222222'", "crosses"};
endfor
film ("out/double.gif", frames, "view", [-10, 45], "axis", 0.05, "width", 520);
