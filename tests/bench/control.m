## control.m: the bench of controllers on a machine, called by `make bench-control`. Writes
## control.md beside itself.
##
## An arm that stands upright, held by a motor with gear, 3 V; dry friction, steps of encoder and
## converter, samples at 500 Hz, 0.5 ms for the computer. Every design of gsmbp_control, gsmbp_pid,
## gsmbp_schedule and gsmbp_lqr on it: what its linear margins promise, and what the machine
## survives: 2.5 to 3 s later it is within 0.2 rad of upright, with more delay (from 0.05 rad)
## within 0.03 rad. Poles: those that are fast enough stay, the one to the right goes to the left.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
pkg load control
out = fullfile (here, "out", "control");
[~, ~] = mkdir (out);

## whether the machine with friction is still at its trim at the end of a run
function [ok, q] = holds (mc, e, angle, force, near = 0.2)
  [ok, q] = deal (false, Inf);
  r = gsmbp_simulate (mc, e.x + [angle; 0; 0], 0:0.02:3, "input", refs_and (mc, e, force));
  q = r.x(:,1) - e.x(1);
  ok = r.t(end) > 2.99 && all (isfinite (q)) && max (abs (q(r.t > 2.5))) < near;
end

## the inputs that nothing holds: the force, and the angle that is wanted
function v = refs_and (mc, e, force)
  v = force;
  if (any (regexp (strjoin (mc.inputs(:)', " "), "angle_ref")))
    v = [force; e.x(1)];
  end
end

## the largest value in steps of 1/32 of top that holds, all smaller ones of the bisection too
function best = largest (holding, top)
  if (! holding (0))
    best = NaN;
    return
  end
  if (holding (top))
    best = Inf;
    return
  end
  [best, worse] = deal (0, top);
  for k = 1:5
    middle = (best + worse) / 2;
    if (holding (middle))
      best = middle;
    else
      worse = middle;
    end
  end
end

function mc = machine (m, c, fc)
  mc = gsmbp_set (gsmbp_build (m.name, "directory", m.directory, "controller", c), "fc", fc);
end

function mc = late (m, c, fc, delay)
  for k = 1:numel (c)
    c.delay = delay;
  end
  if (isfield (c, "schedule"))
    for k = 1:numel (c.schedule.laws)
      c.schedule.laws{k}.delay = delay;
    end
  end
  mc = machine (m, c, fc);
end

## a line of the table
function line = measured (m, e, name, c, loop, fc)
  g = gsmbp_loop (loop);
  mc = machine (m, c, fc);
  angle = largest (@(a) holds (mc, e, a, 0), 1.6);
  force = largest (@(F) holds (mc, e, 0, F), 16);
  delay = largest (@(d) holds (late (m, c, fc, c.delay + d), e, 0.05, 0, 0.03), ...
                   0.08);
  [~, q] = holds (mc, e, 0.05, 0);
  line = sprintf ("| %s | %.1f | %s | %.2f | %.1f | %s | %s | %s | %.1f |\n", name, ...
                  g.phase * 180 / pi, ends (g), g.Ms, 1e3 * g.delay, shown (1e3 * delay, 80), ...
                  shown (angle, 1.6), shown (force, 16), 1e3 * max (abs (q(end-24:end))));
  fputs (stdout, line);
end

function s = ends (g)
  s = sprintf ("%.2f to %.1f", g.gain_down, g.gain);
end

function s = shown (value, top)
  if (isinf (value))
    s = sprintf ("over %g", top);
  elseif (isnan (value))
    s = "never";
  else
    s = sprintf ("%.3g", value);
  end
end

gsmbp_derive (fullfile (here, "control", "benched.mac"), out);
m = gsmbp_build ("benched", "directory", out);
trim_at = @(q) gsmbp_trim (m, [q; 0; 0], [], "hold", "q", "free", "drive.v");
e = trim_at (pi/2);
fc = 0.3;
common = {"period", 2e-3, "delay", 5e-4, "limits", 3, "step_out", 6/4096, "inputs", "drive.v"};
encoder = {"measured", "angle", "step_in", 2*pi/4096};
all_ = {"step_in", [2*pi/4096, 0.02, 0.01]};
two = {"measured", {"angle", "speed"}, "step_in", [2*pi/4096, 0.02]};
cost = {"Q", [100 1 1e-4], "R", 0.01};
noise = {"W", [1e-4 1 1], "V", 2e-7};
poles_ = {"poles", [-10, -14, -336]};   # without: 2.6, -9.9, -336
state = @(q) gsmbp_control (m, trim_at (q), "lqr", cost{:}, "track", "angle", common{:}, ...
                            all_{:});
places = pi/2 + [-0.5 -0.25 0 0.25 0.5];
laws = arrayfun (state, places, "UniformOutput", false);
K = {...
  "LQR", laws{3}
  "LQG", gsmbp_control(m, e, "lqg", cost{:}, noise{:}, common{:}, encoder{:})
  "poles, full observer", gsmbp_control(m, e, "place", poles_{:}, "observer", "full", ...
                                        common{:}, encoder{:})
  "poles, reduced observer", gsmbp_control(m, e, "place", poles_{:}, "observer", "reduced", ...
                                           common{:}, encoder{:})
  "static output feedback", gsmbp_control(m, e, "output", cost{:}, common{:}, two{:})
  "LQG with integral", gsmbp_control(m, e, "lqg", cost{:}, noise{:}, "integral", "angle", ...
                                     "Qi", 1000, common{:}, encoder{:})
  "H-infinity", gsmbp_control(m, e, "hinf", "weights", {tf(0.5, [0.2 1]), 0.01, []}, ...
                              common{:}, encoder{:})
  "PID, Ms 1.6", gsmbp_pid(m, e, "pid", "ms", 1.6, "Ti", 0.4, "Td", 0.1, common{:}, encoder{:})
  "schedule of five LQR", gsmbp_schedule(laws, "angle", places, "start", 3)};
text = "";
for k = 1:rows (K)
  loop = K{k,2};
  if (isfield (loop, "schedule"))
    loop = loop.schedule.laws{3};
  end
  text = [text, measured(m, e, K{k,1}, K{k,2}, loop, fc)];
end

## the swing from hanging to upright in 0.8 s, held by gains along the motion (weights 1, 0.1, 1e-4
## of the states, 1 of the voltage), 18 V: no samples in it. The cost is that of the linear feedback
## without friction and limit, from 0.3 rad beside the plan
function line = along (m, fc, word, name)
  [Q, T] = deal ([1, 0.1, 1e-4], 0.8);
  plan = gsmbp_plan ("quintic", [-pi/2, pi/2], [0 T]);
  d = gsmbp_lqr (m, plan, linspace (0, T, 16), diag (Q), 1, "inputs", "drive.v", "design", word);
  x0 = gsmbp_inverse (m, plan, 0).x';
  law = {"motion", plan, "gain", d.gain, "reference", d.reference};
  t = linspace (0, T, 201)';
  r = gsmbp_simulate (m, x0 + [0.3; 0; 0], t, law{:});
  ref = gsmbp_inverse (m, plan, t);
  cost = trapz (t, (r.x - ref.x) .^ 2 * Q' + (r.v(:,2) - ref.v(:,2)) .^ 2);
  ends_ = @(a, load) abs (gsmbp_simulate (gsmbp_set (m, "fc", fc, "l", 0.25 * load), ...
                          x0 + [a; 0; 0], [0 T], law{:}, "limits", [Inf; 18]).x(end,1) - pi/2);
  angle = largest (@(a) ends_ (a, 1) < 0.05, 1.6);
  longer = largest (@(s) ends_ (0, 1 + s) < 0.05, 3);
  line = sprintf ("| %s | %.4f | %.4f | %s | %s |\n", name, cost, ends_ (0.5, 1), ...
                  shown (angle, 1.6), shown (100 * longer, 300));
  fputs (stdout, line);
end

swing = [along(m, fc, "frozen", "frozen"), along(m, fc, "varying", "varying")];

f = fopen (fullfile (here, "control.md"), "w");
fprintf (f, ["# Controllers on a machine with limits, friction, samples, steps and delay\n\n" ...
             "Written by `make bench-control`; the machine and what is measured: control.m.\n\n" ...
             "| design | phase margin, deg | gain margins | Ms | more delay promised, ms | " ...
             "reached, ms | angle at the start, rad | force at the end of the arm, N | " ...
             "rest, mrad |\n|---|---|---|---|---|---|---|---|---|\n%s\n" ...
             "Along a swing from hanging to upright in 0.8 s, gains without samples:\n\n" ...
             "| design | cost from 0.3 rad beside | at the end, from 0.5 rad beside, rad | " ...
             "angle beside that ends within 0.05 rad | arm longer that does, %% |\n" ...
             "|---|---|---|---|---|\n%s"], text, swing);
fclose (f);
