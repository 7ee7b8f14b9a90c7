## Events of runs in lanes: those of single runs, at the same times; the same bits whatever the
## order, the number of threads and the runs beside. Trees and loops, ports that stick and hit
## stops, events of the user that report, reset, switch and end the run, by expressions of states
## and of reactions; events that accumulate. EVT_W, beside EVT: tests/sh/lane_events.sh.

function test_lanes_events ()
  warning ("off", "gsmbp:stiff", "local");
  rand ("twister", 11);
  ends ("lane_event_pull", @(n) [2 * part(n, 2), 4 * part(n, 2)], "m2", [0.8, 1.2], 1);
  ends ("user_section", @(n) [part(n, 1), 4.43 + 0.6 * part(n, 1)], "l", [1, 1.01], 2);
  ends_of_loops (gsmbp_fixture ("lane_event_loop"));
  arm (gsmbp_fixture ("lane_events"));
  bounces (gsmbp_fixture ("user_bounce"));
  switches (gsmbp_fixture ("user_thermostat"));
  dips (gsmbp_fixture ("lane_dips"));
  beyond (gsmbp_fixture ("lane_event_pull"));
end

function x = part (n, k)
  x = 2 * rand (n, k) - 1;
end

function same = equal (e, i, f, k)
  same = isequaln (e.x(:,:,i), f.x(:,:,k)) && isequal (e.reached(i), f.reached(k)) ...
           && isequal (e.calls(i), f.calls(k)) && isequal (e.reason(i), f.reason(k));
end

## E, runs by one thread with the options O, of which the rows WHERE are by run: beside single runs,
## to TOL, in another order by three threads, and each of some alone
function beside (name, m, x0, t, o, where, e, tol)
  n = size (e.x, 3);
  f = gsmbp_ensemble (m, x0, t, o{:}, "lanes", false);
  gsmbp_check ([name ": in lanes, as one after the other"], ...
               e.lanes && isequal (e.ok, f.ok) && isequal (isnan (e.x), isnan (f.x)));
  d = (e.x - f.x) ./ (1 + abs (f.x));
  gsmbp_check ([name ": their states"], d(! isnan (d)), tol);
  gsmbp_check ([name ": where they end"], e.reached - f.reached, tol);
  gsmbp_check (sprintf ("%s: the same %d events", name, numel (e.events.t)), ...
               ! isempty (e.events.t) && same_events (e, f, tol));
  order = randperm (n);
  g = gsmbp_ensemble (m, x0, t, some (o, where, order){:}, "threads", 3);
  gsmbp_check ([name ": in another order, by three threads, bit for bit"], ...
               equal (g, 1:n, e, order));
  for k = [1, n]
    g = gsmbp_ensemble (m, x0, t, some (o, where, k){:});
    gsmbp_check (sprintf ("%s: run %d alone, bit for bit", name, k), ...
                 g.lanes && equal (g, 1, e, k));
  end
end

function o = some (o, where, k)
  for i = where
    if (isstruct (o{i}))
      o{i} = structfun (@(x) x(k), o{i}, "UniformOutput", false);
    else
      o{i} = o{i}(k,:);
    end
  end
end

## runs of which some are ended by their last event: when, beside gsmbp_simulate
function ends (name, starts, parameter, range, least)
  m = gsmbp_fixture (name);
  n = 37;
  t = [0, 0.7, 2];
  o = {"starts", starts(n), "parameters", struct(parameter, linspace (range(1), range(2), n)'), ...
       "rtol", 1e-10, "atol", 1e-11};
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  beside (name, m, [], t, o, [2, 4], e, 1e-7);
  ended = find (e.reached < 2)';
  gsmbp_check (sprintf ("%s: %d of %d runs are ended by an event", name, numel (ended), n), ...
               numel (ended) >= least && numel (ended) < n);
  for k = ended(1:least)
    one = gsmbp_simulate (gsmbp_set (m, parameter, o{4}.(parameter)(k)), o{2}(k,:), t, o{5:end});
    gsmbp_check (sprintf ("%s: when run %d ends", name, k), ...
                 e.reached(k) - one.events.t(end), 1e-8);
  end
end

function ends_of_loops (m)
  n = 21;
  t = [0, 0.5, 1.5];
  o = {"parameters", struct("last", linspace (5, 9, n)', "r", linspace (0.09, 0.11, n)'), ...
       "start", "project", "rtol", 1e-9, "atol", 1e-10};
  x0 = m.initial;
  x0(m.sizes.nq + 1) = 12;
  e = gsmbp_ensemble (m, x0, t, o{:}, "threads", 1);
  beside ("a slider-crank", m, x0, t, o, 2, e, 1e-6);
  gsmbp_check ("a slider-crank: an event ends the runs", all (e.ok) && all (e.reached < 1.5));
  one = gsmbp_simulate (gsmbp_set (m, "last", 5, "r", 0.09), e.x(1,:,1), t, o{5:end});
  gsmbp_check ("a slider-crank: when", e.reached(1) - one.events.t(end), 1e-7);
end

function arm (m)
  n = 40;
  t = 0:0.25:1.5;
  starts = [part(n, 2), 2 * part(n, 2)];
  starts(1:8,3) = 0;
  o = {"starts", starts, "inputs", 3 * part(n, 1), "parameters", struct("f", 1 + rand (n, 1)), ...
       "rtol", 1e-9, "atol", 1e-10};
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  beside ("an arm", m, [], t, o, [2, 4, 6], e, 1e-5);
  gsmbp_check ("an arm: all come to their end", all (e.ok));
  [stopped, thrown] = deal (0);
  for k = 1:5
    mk = gsmbp_set (m, "f", o{6}.f(k));
    one = gsmbp_simulate (mk, starts(k,:), t, "input", o{4}(k), o{7:end});
    gsmbp_check (sprintf ("an arm: run %d as by itself", k), e.x(:,:,k) - one.x, 1e-5);
    stopped += any (one.events.number == 2);
    thrown += any (one.events.number == 6);
  end
  gsmbp_check ("an arm: it hits the stop, and is thrown back", stopped > 0 && thrown > 0);
end

## Where bounces accumulate rounding errors say which are the last: up to six, of heights of 1e-15,
## may be missing on either side, all of them within TOL of the last that both have.
function same = same_events (e, f, tol)
  same = true;
  for k = 1:numel (e.ok)
    [a, b] = deal (e.events.run == k, f.events.run == k);
    [ta, tb, na, nb] = deal (e.events.t(a), f.events.t(b), e.events.number(a), f.events.number(b));
    m = min (numel (ta), numel (tb));
    same = same && isequal (na(1:m), nb(1:m)) && all (abs (ta(1:m) - tb(1:m)) < tol) ...
             && (numel (ta) == numel (tb)
                 || (! e.ok(k) && m > 20 && abs (numel (ta) - numel (tb)) <= 6 ...
                     && max ([ta; tb]) - ta(m) < tol));
  end
end

## resets, a time that ends the runs; bounces that accumulate are an error of those runs
function bounces (m)
  n = 33;
  t = 0:0.5:4;
  o = {"starts", [1 + 0.3 * part(n, 1), part(n, 1)], "parameters", ...
       struct("e", linspace (0.3, 0.9, n)', "last", linspace (5, 2, n)')};
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  beside ("a ball", m, [], t, o, [2, 4], e, 1e-6);
  ended = e.ok & e.reached < 4;
  gsmbp_check ("a ball: its time ends a run", ...
               any (ended) && max (abs (e.reached(ended) - o{4}.last(ended))) < 1e-12);
  heard = ! cellfun ("isempty", strfind (e.reason, "faster and faster"));
  gsmbp_check ("a ball: bounces that accumulate", any (heard) && ! all (heard) ...
                 && isequal (heard(:), ! e.ok(:)));
end

## between two thresholds by an input that events switch: a closed form of its period
function switches (m)
  n = 24;
  power = linspace (2.5, 4, n)';
  o = {"starts", [zeros(n, 1), 1.5 * ones(n, 1)], "inputs", zeros(n, 1), "parameters", ...
       struct("power", power), "rtol", 1e-9, "atol", 1e-10};
  t = 0:0.5:6;
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  beside ("a room", m, [], t, o, [2, 4, 6], e, 1e-7);
  for k = [1, n]
    gsmbp_check (sprintf ("a room: run %d in closed form", k), ...
                 e.x(:,2,k) - room (t, power(k)), 1e-7);
  end
end

## its speed: x' = p - x from 1 up to 2, x' = -x down to 1
function x = room (t, p)
  x = zeros (numel (t), 1);
  down = log (2);
  up = log ((p - 1) / (p - 2));
  for i = 1:numel (t)
    s = t(i) - log (1.5);
    if (s < 0)
      x(i) = 1.5 * exp (-t(i));
      continue;
    end
    s = mod (s, up + down);
    if (s < up)
      x(i) = p - (p - 1) * exp (-s);
    else
      x(i) = 2 * exp (up - s);
    end
  end
end

## a place that is passed for a short part of a step, or not at all: when, in closed form
function dips (m)
  by = [10.^(-2:-0.25:-7), -10.^(-2:-1:-5)]';
  n = numel (by);
  e = gsmbp_ensemble (m, [0 0], [0, 4], "parameters", struct("h", 2 - by), "threads", 1);
  t = 4 * ones (n, 1);
  t(by > 0) = acos (by(by > 0) - 1);
  gsmbp_check ("a place that is hardly reached, in lanes", ...
               (e.reached - t) ./ (1e-9 + 0.01 * sqrt (2 * abs (by))), 1);
end

## a function that is below 0 at the start, rises in a step without an event and falls to 0 then
function beyond (m)
  n = 16;
  o = {"starts", [zeros(n, 1), linspace(1.6, 2.2, n)', zeros(n, 2)], "rtol", 1e-10, "atol", 1e-11};
  e = gsmbp_ensemble (m, [], [0, 4], o{:}, "threads", 1);
  f = gsmbp_ensemble (m, [], [0, 4], o{:}, "lanes", false);
  gsmbp_check ("starts beyond the end: where they come back to it", ...
               all (e.reached > 0.1) && sum (e.reached < 4) > 3);
  gsmbp_check ("starts beyond the end: when", e.reached - f.reached, 1e-8);
end
