## Two-link flexible arm: frequencies over the elbow's angle, rest-to-rest motions by the torques
## of the rigid arm and a feedback of the joints; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## the states along a motion of the joints, modes at rest
function x0 = whole_state (motion, modes)
  rate = ppder (motion);
  k = motion.order - rate.order;
  zero = zeros (modes, motion.pieces, motion.order);
  q = cat (1, reshape (motion.coefs, 2, [], motion.order), zero);
  u = cat (1, cat (3, zeros (2, motion.pieces, k), reshape (rate.coefs, 2, [], rate.order)), zero);
  x0 = mkpp (motion.breaks, reshape (cat (1, q, u), [], motion.order), 2 * (2 + modes));
endfunction

## the run of M by the torques of the rigid arm (a table of them) and a feedback of its joints: tip
## and where the rigid arm has it, along T
function [r, tip, path] = moved (m, rigid, ends, T, t)
  motion = gsmbp_plan ("septic", ends, [0 T]);
  plan = gsmbp_inverse (rigid, motion, t);
  modes = m.sizes.nq - 2;
  gain = [diag([100 50]), zeros(2, modes), diag([10 5]), zeros(2, modes)];
  torques = gsmbp_plan ("table", t, plan.tau);
  x0 = [ends(:,1); zeros(2 + 2*modes, 1)];
  r = gsmbp_simulate (m, x0, t, "input", torques, "gain", gain, "reference", ...
                      whole_state (motion, modes), "rtol", 1e-8);
  tip = r.y(:,1:2);
  path = plan.y;
endfunction

m = derived_model ("two_link_arm");
gsmbp_derive ("two_link_rigid.mac", "out");
rigid = gsmbp_build ("two_link_rigid", "directory", "out");

## --------------------------------------------------------------- vibrations
angles = (0:10:150)';
for k = 1:numel (angles)
  x = [0; angles(k) * pi / 180; zeros(10, 1)];
  held(k,:) = gsmbp_modes (m, x, "hold", {"q1", "q2"}).frequency;
  loose(k,:) = gsmbp_modes (m, x, "hold", "q1").frequency(1:4);
endfor
puts ("\nfrequencies [rad/s] over the elbow's angle, both joints held\n");
printf ("%14s %10s %10s %10s %10s\n", "elbow [deg]", "first", "second", "third", "fourth");
printf ("%14g %10.3f %10.3f %10.3f %10.3f\n", [angles(1:3:end), held(1:3:end,:)]');
gsmbp_plot ("out/figure_modes.png", angles, ...
            panel (held(:,1:2), {"first, joints held", "second, joints held"}, ...
                   "frequency [rad/s]"), ...
            panel (loose(:,1), {"first, elbow free"}, "frequency [rad/s]"), "xlabel", ...
            "angle of the elbow [degrees]", "title", "Vibrations of the arm by its pose", ...
            "head", "elbow");

## --------------------------------------------------------------- motions
ends = [0 pi/2; 0.3 1.2];
durations = [0.4 0.6 0.8 1.2];
puts (["\nfrom rest to rest by the torques of the rigid arm: tip off its path, and after the " ...
       "end [mm]\n"]);
printf ("%14s %14s %14s %14s\n", "duration [s]", "on the way", "after", "torque [N m]");
for T = durations
  t = linspace (0, T + 0.6, 601)';
  [r, tip, path] = moved (m, rigid, ends, T, t);
  off = 1e3 * sqrt (sumsq (tip - path, 2));
  printf ("%14g %14.3f %14.3f %14.3f\n", T, max (off(t <= T)), max (off(t > T)), ...
          max (abs (r.v(:,1))));
  if (T == 0.6)
    shown = {t, r, off};
  endif
endfor
[t, r, off] = shown{:};
gsmbp_plot ("out/figure_motion.png", t, panel (r.x(:,1:2), {"q1", "q2"}, "angle [rad]"), ...
            panel (off, {"tip off its path"}, "distance [mm]"), ...
            panel (r.y(:,3), {"root"}, "moment [N m]"), "title", ...
            "A motion of 0.6 s by the torques of the rigid arm");
some = 1:5:400;
film_ = struct ("t", t(some), "x", r.x(some,:));
gsmbp_animate (m, film_, "out/motion.gif");

## --------------------------------------------------------------- what it costs
puts ("\n");
gsmbp_timing (m, 0.1, r.x(200,:), "input", r.v(200,:));
puts ("\n");
gsmbp_workprecision (m, r.x(150,:)', [0 0.3], "input", [0; 0], "rk4", ...
                     [5e-4 2e-4 1e-4], "dp853", 10 .^ -(4:2:12), "file", ...
                     "out/speed_error.png", "seconds", 0.05);
diary off
