## Bodies that a force shakes between stops, with restitution and dry friction, of random kinds,
## at loose tolerances: each flight and each slide against closed forms, from one event to the next.
## What is passed without an event, and what an event is off by, the tolerance must explain.

function test_events_loose ()
  warning ("off", "gsmbp:stiff", "local");
  for rtol = [1e-6 1e-8]
    shaken (gsmbp_fixture ("event_shaken"), 40, rtol, false);
    shaken (gsmbp_fixture ("event_rubbed"), 25, rtol, true);
  end
end

function shaken (m, n, rtol, rubs)
  [p, starts] = scenes (n, rubs);
  what = {"stop passed [m]", "state at the next event", "slides back [m/s]", ...
          "impact off its stop [m]"};
  most = zeros (n, 4);
  ends = 0;
  for k = 1:n
    [r, info] = run (m, p(k), starts(k,:), rtol);
    ends += info == 0;
    most(k,:) = flights (r, p(k), starts(k,:));
  end
  scene = sprintf ("%s, rtol %g", m.name, rtol);
  gsmbp_check (sprintf ("%s: %d of %d runs come to their end", scene, ends, n), ends == n);
  for j = 1:4
    limit = 5 * rtol;     # a flight takes a few steps, at ten tolerances something is passed
    if (j == 4)
      limit = 1e-12;      # whatever the tolerance: the step is made again up to the stop
    end
    gsmbp_check (sprintf ("%s: %s", scene, what{j}), most(:,j), limit);
  end
end

function [r, info] = run (m, p, start, rtol)
  set = [fieldnames(p), struct2cell(p)]';
  if (p.fc == 0)
    set = set(:,! strcmp (set(1,:), "fc"));
  end
  [r, info] = gsmbp_simulate (gsmbp_set (m, set{:}), start, [0 5], "rtol", rtol, "timeout", 60);
end

## parameters and starts; where nothing rubs fc is 0
function [p, starts] = scenes (n, rubs)
  rand ("twister", 11);
  u = @(a, b) num2cell (a + (b - a) * rand (n, 1));
  hi = 10 .^ (-2 + 1.7 * rand (n, 1));
  p = struct ("A", u (0.5, 6), "B", u (-2.5, 2.5), "w", u (2.5, 19), "hi", num2cell (hi), ...
              "e", u (0, 0.95), "fc", u (0.2 * rubs, 2 * rubs));
  starts = [0.9 * hi .* (2 * rand (n, 1) - 1), rand(n, 1) - 0.5];
end

## the worst of each kind in a run
function most = flights (r, p, x)
  e = r.events;
  most = zeros (1, 4);
  t = 0;
  slides = sign (x(2)) * (p.fc > 0);
  contact = 0;
  for k = 1:numel (e.t) + 1
    last = k > numel (e.t);
    next = ifelse (last, r.t(end), @() e.t(k));
    found = ifelse (last, r.x(end,:), @() e.before(k,:));
    if (next > t && (contact != 0 || (p.fc > 0 && slides == 0)))
      most(2) = max ([most(2), abs(found - [x(1), 0])]);
    elseif (next > t)
      [s, v] = flight (p, slides, t, x, linspace (t, next, 100));
      most(1) = max ([most(1), abs(s) - p.hi]);
      most(2) = max ([most(2), abs([s(end), v(end)] - found)]);
      most(3) = max ([most(3), -slides * v]);
    end
    if (last)
      return;
    end
    t = next;
    x = e.after(k,:);
    if (! strcmp (e.name{k}, "S"))
      slides = e.mode(k);
    else
      contact = e.mode(k);
      if (any (x != found) || contact != 0)
        most(4) = max (most(4), abs (abs (x(1)) - p.hi));
      end
      if (p.fc > 0 && abs (x(2)) > 1e-9)
        slides = sign (x(2));
      end
    end
  end
end

function x = ifelse (is, x, other)
  if (! is)
    x = other ();
  end
end

## place and speed at the times T behind T0, in closed form: 1 kg under A*sin(w*t) + B and friction
function [s, v] = flight (p, slides, t0, x, t)
  a = p.B - slides * p.fc;
  d = t - t0;
  v = x(2) + a * d - p.A / p.w * (cos (p.w * t) - cos (p.w * t0));
  s = x(1) + x(2) * d + a * d .^ 2 / 2 + p.A / p.w * cos (p.w * t0) * d ...
      - p.A / p.w ^ 2 * (sin (p.w * t) - sin (p.w * t0));
end
