## Events of the user whose function stays at zero, or seems to: reports on speeds that friction
## holds, resets that count, bounces that drown in rounding errors; by every method.

function test_events_accumulate ()
  warning ("off", "gsmbp:stiff", "local");
  warning ("off", "gsmbp:atol", "local");
  warning ("off", "gsmbp:events", "local");
  held (gsmbp_fixture ("user_held"));
  count (gsmbp_fixture ("user_count"));
  thrown_back (gsmbp_fixture ("user_wall"));
  late (gsmbp_fixture ("user_wall"));
end

## bounces that accumulate behind more events than the record has places for
function late (m)
  m = gsmbp_set (m, "many", 3e4);
  [r, info] = gsmbp_simulate (m, [0.5 0 0 0 0 5], 0:0.01:2, "maxstep", 2e-5);
  gsmbp_check (sprintf ("thrown back behind %d events", r.stats.events), ...
               info == 3 && r.stats.events > 10000 && all (sin (r.x(:,1)) + 0.3 > -1e-9));
end

## The methods tell the same reports, none while what holds the speed holds it, none again as it
## slips, and each time the sign of the speed was another one.
function held (m)
  rand ("twister", 7);
  n = 40;
  u = @(a, b) num2cell (a + (b - a) * rand (n, 1));
  fc = 0.2 + 2 * rand (n, 1);
  p = struct ("A", u (1, 6), "B", u (-2, 2), "w", u (2, 17), "k", u (5, 55), ...
              "fc", num2cell (fc), "fs", num2cell (fc .* (1 + 0.5 * rand (n, 1))));
  speed = (2 * rand (n, 1) - 1) .* (rand (n, 1) > 0.5);
  told = {};
  for method = {"dp853", "rk4", "radau", "gauss"}
    [ends, wrong, missed] = deal (0);
    told{end+1} = zeros (n, 3);
    for k = 1:n
      set = [fieldnames(p), struct2cell(p(k))]';
      [r, info] = gsmbp_simulate (gsmbp_set (m, set{:}), [0 0 speed(k) 0], 0:1e-3:6, "step", ...
                                  1e-3, "method", method{1}, "timeout", 60);
      ends += info == 0;
      [told{end}(k,:), bad] = reports (r);
      wrong += bad;
      missed += any (told{end}(k,1:2) < turns (r.x(:,3:4)));
    end
    gsmbp_check (sprintf ("held speeds, %s: %d of %d runs to their end", method{1}, ends, n), ...
                 ends == n);
    gsmbp_check ("... nothing is told while they are held", wrong == 0);
    gsmbp_check ("... whenever they turn", missed == 0);
    gsmbp_check ("... the same as dp853", told{end} - told{1}, 0);
  end
  gsmbp_check ("held speeds: many turns", sum (told{1}(:)) > 500);
end

## how many reports of each kind; those while the port of that speed is held, or as it slips
function [many, wrong] = reports (r)
  e = r.events;
  names = {"turn_a", "turn_b", "turn"};
  many = cellfun (@(name) nnz (strcmp (e.name, name)), names);
  wrong = 0;
  since = [-1, -1];
  mode = [1, 1];
  for k = 1:numel (e.t)
    port = find (strcmp (e.name{k}, {"Fa", "Fb"}));
    mode(port) = e.mode(k);
    since(port) = e.t(k);
    which = find (strcmp (e.name{k}, names));
    if (which == 3)
      wrong += all (mode == 0) && e.t(k) > max (since) + 1e-9;
    elseif (which)
      wrong += e.t(k) > since(which) && (mode(which) == 0 || e.t(k) < since(which) + 1e-6);
    end
  end
end

## how often each speed has lost its sign, as far as the rows show
function many = turns (v)
  for k = 1:2
    s = sign (v(:,k) .* (abs (v(:,k)) > 1e-12));
    many(k) = nnz (diff (s) != 0 & s(1:end-1) != 0);
  end
end

## an event that resets a counter may come at intervals that fall, and then no more
function count (m)
  rand ("twister", 3);
  n = 60;
  starts = [pi * (2 * rand(n, 1) - 1), 4 * rand(n, 1) - 2, zeros(n, 1), 6 * rand(n, 2) - 3, ...
            zeros(n, 1)];
  e = gsmbp_ensemble (m, [], [0 20], "starts", starts);
  gsmbp_check ("a counter: all runs come to their end", all (e.ok));
  many = accumarray (e.events.run(:), 1, [n, 1]);
  gsmbp_check ("a counter: it counts the events", squeeze (e.x(end,3,:)) - many, 0);
  gsmbp_check ("a counter: many events", sum (many) > 500);
end

## bounces that accumulate end a run; none goes on below the floor
function thrown_back (m)
  rand ("twister", 5);
  n = 30;
  fell = 0;
  for method = {"dp853", "rk4", "radau", "gauss"}
    [fell, heard] = deal (0);
    for k = 1:n
      [b, e, start, speed] = deal (0.2 + 0.6 * rand, 0.1 + 0.5 * rand, rand, 4 * rand - 2);
      d = 1e-3 * (mod (k, 3) == 0);
      rtol = 10 ^ (-4 - 7 * rand);
      set = {"b", b, "e", e, "d", d};
      [r, info] = gsmbp_simulate (gsmbp_set (m, set{:}), [start 0 0 speed 0 5], 0:0.01:10, ...
                                  "method", method{1}, "rtol", rtol, "step", 1e-3);
      height = sin (r.x(:,1)) + b + d * sin (r.x(:,3));
      fell += info == 0 && any (height < -1e-9);
      heard += info == 3;
    end
    gsmbp_check (sprintf ("thrown back, %s: none falls through the floor", method{1}), fell == 0);
    gsmbp_check (sprintf ("... of %d runs %d end as their bounces accumulate", n, heard), ...
                 heard > n / 2);
  end
end
