## Several ports that are let go, held or hit at one instant: friction and a stop in one joint, two
## frictions in one, friction in all joints of an arm; starts on a stop. Against closed forms, other
## methods, other tolerances and the balance of energy.

function test_events_together ()
  warning ("off", "gsmbp:stiff", "local");
  arm (gsmbp_fixture ("event_joint"));
  pushed (gsmbp_fixture ("event_slider"));
  shaken (gsmbp_fixture ("event_shaken"));
  pair (gsmbp_fixture ("event_pair"));
  stack (gsmbp_fixture ("event_stack"));
  start_on_a_stop (gsmbp_fixture ("batch_stop"));
  dips (gsmbp_fixture ("user_dips"));
end

## all runs come to their end, the same ones in lanes and by themselves
function arm (m)
  rand ("twister", 3);
  n = 60;
  half = @(k) 2 * rand (n, k) - 1;
  starts = [half(2), 0.3 * half(1) - 0.1, 3 * half(3)];
  starts(1:15,4:6) = 0;
  starts(16:25,5) = 0;
  table = struct ("m1", 1 + rand (n, 1), "f1", 3 + rand (n, 1), "e", rand (n, 1));
  efforts = 3 * half (3);
  o = {"starts", starts, "inputs", efforts, "parameters", table, "timeout", 60};
  e = gsmbp_ensemble (m, [], 0:0.5:3, o{:});
  f = gsmbp_ensemble (m, [], 0:0.5:3, o{:}, "lanes", false);
  gsmbp_check ("an arm with friction and a stop: in lanes, all come to their end", ...
               e.lanes && all (e.ok) && all (f.ok));
  d = squeeze (max (max (abs (e.x - f.x), [], 1), [], 2));
  gsmbp_check ("as one after the other", d, 1e-4);
  for k = [3, 20, 40]
    mk = gsmbp_set (m, "m1", table.m1(k), "f1", table.f1(k), "e", table.e(k));
    o = {"input", efforts(k,:)', "rtol", 1e-10, "atol", 1e-11};
    r = gsmbp_simulate (mk, starts(k,:), 0:0.5:3, o{:}, "audit", 10);
    gsmbp_check (sprintf ("run %d: balance of energy", k), r.audit.error, 1e-8);
    s = gsmbp_simulate (mk, starts(k,:), 0:0.5:3, o{:}, "method", "radau");
    gsmbp_check (sprintf ("run %d by radau", k), r.x - s.x, 1e-5);
  end
end

## pressed against a stop, let go, pressed again: the stop and the friction beside it take turns
function pushed (m)
  for p = {2.5, 3, 0.3; 4, 0, 0.3; 4, 0, 0.9; 5, 0, 0.3}'
    mp = gsmbp_set (m, "A", p{1}, "B", p{2}, "e", p{3});
    what = sprintf ("a push of %g sin + %g, restitution %g", p{:});
    r = gsmbp_simulate (mp, [0 0], 0:0.25:4, "timeout", 60);
    gsmbp_check ([what ": comes to its end"], r.t(end) == 4);
    c = gsmbp_simulate (mp, [0 0], 0:0.25:4, "method", "radau", "timeout", 60);
    gsmbp_check ([what ": by radau"], r.x - c.x, 1e-6);
    gsmbp_check ([what ": never beyond the stop"], max (abs (r.x(:,1))) - 0.05 < 1e-9);
  end
  far = gsmbp_set (m, "hi", 100, "A", 3.73, "B", 1.18, "fc", 0.52);
  r = gsmbp_simulate (far, [0 0], 0:0.1:3, "rtol", 1e-6);
  s = gsmbp_simulate (far, [0 0], 0:0.1:3, "rtol", 1e-10, "method", "radau");
  gsmbp_check ("friction that is let go slides, at a loose tolerance", r.x - s.x, 1e-4);
end

function shaken (m)
  m = gsmbp_set (m, "A", 3.26, "B", 1.81, "e", 0.54);
  r = gsmbp_simulate (m, [0 0], [0 3]);
  s = gsmbp_simulate (m, [0 0], 0:0.002:3);
  q = gsmbp_simulate (m, [0 0], [0 3], "method", "radau");
  gsmbp_check ("impacts up to contact, whatever rows are asked for", ...
               r.x(end,:) - s.x(end,:), 1e-9);
  gsmbp_check ("the same by radau", r.x(end,:) - q.x(end,:), 1e-7);
  gsmbp_check ("the same events", isequal (r.events.mode, s.events.mode, q.events.mode));
end

## both slide, turn and stick as one friction of their sum
function pair (m)
  n = 0;
  for push = -6.25:1.25:6.25
    for v = [-0.2, 0.05, 0.2]
      r = gsmbp_simulate (m, [0 v], [0 1], "input", push, "timeout", 20);
      n += norm (r.x(end,:) - closed (push, v), Inf) < 1e-9;
    end
  end
  gsmbp_check (sprintf ("two frictions in a joint: %d of 33 as in closed form", n), n == 33);
end

## place and speed after 1 s, against 3 N
function x = closed (push, v)
  a = push - 3 * sign (v);
  stop = -v / a;
  if (stop > 1 || stop < 0)
    x = [v + a / 2, v + a];
    return;
  end
  x = [v * stop / 2, 0];
  if (abs (push) > 3)
    b = push - 3 * sign (push);
    x += [b * (1 - stop)^2 / 2, b * (1 - stop)];
  end
end

## a push of 5 N from 1 s on, more than either friction holds: only the upper block, whose friction
## lacks most, is let go; it loads the lower one with 1 N
function stack (m)
  r = gsmbp_simulate (m, zeros (1, 4), [0 1 2], "input", mkpp (0:2, [0; 5]));
  gsmbp_check ("of two that may be let go, the one that lacks most", ...
               isequal (r.events.name, {"F2"}) && r.events.mode == 1);
  gsmbp_check ("... and where they are then", r.x(end,:) - [0, 2, 0, 4], 1e-9);
end

function start_on_a_stop (m)
  for way = {0.5, 1; -0.2, -1}'
    r = gsmbp_simulate (m, [way{1}, 0, way{2}, 0], [0 0.01]);
    gsmbp_check (sprintf ("a start on the stop at %g m, moving into it, is an impact", way{1}), ...
                 [r.events.t(1), r.events.after(1,3) + 0.7 * way{2}], 1e-12);
  end
end

## a place that is passed for a short part of a step: 2 - h beyond it, in closed form
function dips (m)
  for beyond = [1e-3, 1e-5, 1e-7]
    for rtol = [1e-8, 1e-10]
      r = gsmbp_simulate (gsmbp_set (m, "h", 2 - beyond), [0 0], [0 20], "rtol", rtol);
      half = acos (1 - beyond);
      t = pi * [1 1 3 3 5 5]' + half * [-1 1 -1 1 -1 1]';
      what = sprintf ("what passes by %g for a moment, rtol %g", beyond, rtol);
      gsmbp_check ([what ": six events"], isequal (r.events.number', [1 2 1 2 1 2]));
      gsmbp_check ([what ": when"], (r.events.t - t) / half, 0.1);
    end
  end
end
