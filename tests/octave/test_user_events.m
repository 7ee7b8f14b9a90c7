## Events on expressions of the user: report, stop, reset, switch against closed forms; what begins
## true, comes twice, only touches or accumulates.

function test_user_events ()
  ball ();
  accumulating ();
  restitutions ();
  floors ();
  from_rest ();
  thermostat ();
  recorded ();
  pendulum ();
  crank ();
  many ();
  pair ();
  limit ();
  sums ();
  slab ();
  kicked ();
  again ();
  too_many ();
end

## an event is told just before another one, up to which radau makes its step again, perhaps shorter
## than to the first one
function slab ()
  m = gsmbp_fixture ("event_slab");
  for d = [0.18, 0.25, -0.21, 0.3]
    at = [];
    for method = {"dp853", "radau", "cvode"}
      [r, info] = gsmbp_simulate (m, [0 d 0 0], [0 2], "method", method{1});
      told = strcmp (r.events.name, "go");
      gsmbp_check (sprintf ("a block from %g m, %s: each passage once", d, method{1}), ...
                   info == 0 && all (diff (r.events.t(told)) > 1e-4));
      at = [at, {r.events.t(told)}];
    end
    gsmbp_check ("at the same times", numel (at{1}) == numel (at{2}) ...
                 && max (abs (at{1} - at{2})) < 1e-7);
  end
end

## a sum of coordinates passes a height up and down, as told by events up, down and both ways: its
## rounding errors there are no events
function sums ()
  m = gsmbp_fixture ("event_sum");
  w = sqrt ([m.par.k1, m.par.k2]);
  t = linspace (0, 5, 20001);
  starts = [0.82 0.9 -0.88 -0.6; -0.59 0.88 0.38 0.93; 1 0.7 0.95 -0.09; 0.2 -0.02 0.88 -0.25; ...
            0.25 0.55 0.27 0.44; -0.44 -0.03 0.54 0.38; -0.94 -0.68 -0.12 0.3];
  for method = {"dp853", "rk4", "radau", "gauss", "cvode"}
    wrong = 0;
    for x = starts'
      x = x';
      sum_ = x(1:2) * cos (w' * t) + x(3:4) ./ w * sin (w' * t) - m.par.h;
      [r, info] = gsmbp_simulate (m, x, [0 5], "method", method{1}, "step", 2e-3);
      turns = diff (sum_ > 0);
      count = @(name) nnz (strcmp (r.events.name, name));
      wrong += info != 0 || ! isequal ([count("up"), count("down"), count("pass")], ...
                                       [nnz(turns > 0), nnz(turns < 0), nnz(turns)]);
    end
    gsmbp_check (["a sum passes a height, " method{1}], wrong, 0);
  end
end

## a reaction of a loop that rises through a limit at a steep slope, known but for rounding errors
function limit ()
  counts = [];
  for mass = 1 + [1e-4, 2e-4, 3e-4]
    m = gsmbp_set (gsmbp_fixture ("sensitivity_kick"), "m", mass);
    x = gsmbp_assemble (m, [0.5 -0.6 0.38 3 0 0]', "hold", "phi");
    for tolerance = [1e-10, 1e-13]
      r = gsmbp_simulate (m, x, [0 0.8], "input", 3, "rtol", tolerance);
      counts(end+1) = sum (strcmp (r.events.name, "force"));
    end
  end
  gsmbp_check ("it is told once each time", counts == 2);
end

## statistics of what some runs never have: those of the others, each column by itself
function never (m)
  w = gsmbp_sweep (m, [1 0], 0:0.5:1, "vary", struct ("last", [0.2 1], "g", [8 12]), "runs", 40, ...
                   "keep", {"count hit", "first hit"}, "demand", {"first hit", 0, 1});
  here = w.values(:,3) > 0;
  first = sqrt (2 ./ w.values(here,2));
  gsmbp_check ("some never hit", w.ok & any (here) & ! all (here) ...
                                 & isnan (w.values(:,4)) == ! here);
  gsmbp_check ("mean, deviation, ends, quantiles of the others", ...
               [w.mean(2), w.std(2), w.min(2), w.max(2), w.quantiles(2,2)] ...
                 - [mean(first), std(first), min(first), max(first), median(first)], 1e-8);
  gsmbp_check ("ranks: the heavier the sooner, all of the others", w.correlation(2,2) + 1, 1e-12);
  gsmbp_check ("the demand is kept by these", w.yield - mean (here), 1e-12);
  s = {m, [1 0], 0:0.5:1, "vary", struct("last", [0.2 1], "g", [8 12]), "plan", "indices", ...
       "runs", 63};
  [one, both] = deal (gsmbp_sweep (s{:}, "keep", {"count hit"}), ...
                      gsmbp_sweep (s{:}, "keep", {"first hit", "count hit"}));
  gsmbp_check ("indices of a column do not depend on the others", ...
               [one.first - both.first(:,2), one.total - both.total(:,2)], 0);
end

## two balls that bounce together, with a step from one bounce to the next
function pair ()
  m = gsmbp_fixture ("sensitivity_pair");
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [1; 1; 0; 0], [0 1.5], "method", method{1});
    gsmbp_check (["both bounce twice, " method{1}], ...
                 isequal (sort (r.events.number'), [1 1 2 2]) ...
                 && all (r.x(end,1:2) > 0.4));
  end
end

## thrown back with -e times its speed: every bounce and every top in closed form
function ball ()
  m = gsmbp_fixture ("user_bounce");
  [g, e, h] = deal (9.81, 0.8, 1);
  bounce = sqrt (2 * h / g);
  v = g * bounce;
  top = [];
  while (bounce(end) < 3)
    v *= e;
    top(end+1) = bounce(end) + v / g;
    bounce(end+1) = bounce(end) + 2 * v / g;
  end
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [h 0], 0:0.1:5, "method", method{1}, "step", 0.02);
    of = @(name) r.events.t(strcmp (r.events.name, name));
    near = 1e-12 + 2e-9 * strcmp (method{1}, "cvode");   # at its tolerance, 1e-10
    wanted = bounce(bounce < 3)';
    gsmbp_check (["times of bounces, " method{1}], ...
                 of ("hit") - wanted, near);
    gsmbp_check (["tops, " method{1}], ...
                 of ("top") - (top(top < 3)'), near);
    gsmbp_check (["the end, " method{1}], ...
                 [of("done"), r.t(end)] - [3 3], near);
    gsmbp_check (["what ended it is told, " method{1}], ...
                 strcmp (r.stats.stopped, "event done"));
    after = r.events.after(strcmp (r.events.name, "hit"),2);
    gsmbp_check (["speeds, " method{1}], ...
                 after - (g * bounce(1) * e .^ (1:numel (after))'), near);
  end
end

## bounces that come faster and faster are an error in time, never a ball below the ground
function accumulating ()
  m = gsmbp_set (gsmbp_fixture ("user_bounce"), "e", 0.5, "last", 10);
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    said = "";
    try
      gsmbp_simulate (m, [1 0], [0 5], "method", method{1}, "step", 0.02);
    catch failure
      said = failure.message;
    end
    ## cvode: bounces below its tolerance go on a little
    at = {"1.3545709", "1.35[4-9]"}{1 + strcmp(method{1}, "cvode")};
    gsmbp_check (["bounces that accumulate are told, " method{1}], ...
                 ! isempty (regexp (said, ["an event, (hit|top), failed .* " at], "once")));
  end
  w = gsmbp_sweep (m, [1 0], [0 5], "vary", struct ("last", [10, 20]), ...
                   "plan", "grid", "keep", {"final y"});
  gsmbp_check (["a sweep tells it, too: " w.reason{1}], ! any (w.ok) ...
               && all (! cellfun ("isempty", strfind (w.reason, "comes faster and faster"))));
end

## v' = heat - v between 1 and 2, heated with 3: ln 2 up, ln 2 down; the middle in between
function thermostat ()
  m = gsmbp_fixture ("user_thermostat");
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [0 1.5], [0 5 10], "input", 0, "method", method{1}, "step", 0.01, ...
                        "rtol", 1e-12);
    cold = r.events.t(strcmp (r.events.name, "cold"));
    hot = r.events.t(strcmp (r.events.name, "hot"));
    wanted = log (1.5) + log (2) * (0:2:20)';
    near = 1e-12 + 1e-9 * any (strcmp (method{1}, {"rk4", "cvode"}));
    gsmbp_check (["it gets cold, " method{1}], ...
                 cold ./ wanted(wanted < 10) - 1, near);
    gsmbp_check (["it gets hot, " method{1}], ...
                 hot ./ (wanted(wanted + log (2) < 10) + log (2)) - 1, near);
    middle = r.events.t(strcmp (r.events.name, "middle"));
    gsmbp_check (["both ways through the middle, " method{1}], ...
                 middle(1:2) - (log (1.5) + [log(2 / 1.5); log(2) + log(4 / 3)]), near);
    heated = 3 * (mod (r.t(2:3) - log (1.5), 2 * log (2)) < log (2));
    gsmbp_check (["the input is held, " method{1}], ...
                 r.v(2:3) - heated, 0);
  end
  ## below a threshold at the start: its first step is looked at more closely
  r = gsmbp_simulate (m, [0 0.5], [0 0.15], "input", 3, "method", "gauss", "step", 0.01);
  gsmbp_check ("all steps of gauss are done", r.x(2,2) - (3 - 2.5 * exp (-0.15)), 1e-12);
end

## the record has 10000 events; that there were more, of which all act, is a warning
function recorded ()
  m = gsmbp_fixture ("user_thermostat");
  from = @(first, T) floor ((T - first) / log (2) + 1);
  for T = [3400, 3600]
    lastwarn ("", "");
    r = gsmbp_simulate (m, [0 1.5], [0 T], "input", 0);
    [said, id] = lastwarn ();
    wanted = from (log (1.5), T) + from (log (1.5) + log (4 / 3), T);
    gsmbp_check (sprintf ("events in %g s", T), r.stats.events - wanted, 0);
    gsmbp_check ("those of the record", numel (r.events.t) - min (wanted, 10000), 0);
    told = sprintf ("there were %d events, the result has the first 10000 of them", wanted);
    gsmbp_check (["the warning: " said], strcmp (id, "gsmbp:events") == (wanted > 10000) ...
                 && (wanted <= 10000 || any (strfind (said, told))));
  end
end

## any restitution, ended by any method where its bounces accumulate
function restitutions ()
  for e = [0.01 0.1 0.9]
    m = gsmbp_set (gsmbp_fixture ("user_bounce"), "e", e, "last", 100);
    for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
      said = gsmbp_complaint (@() gsmbp_simulate (m, [1 0], [0 20], "method", method{1}, "step", ...
                                                  0.02));
      gsmbp_check (sprintf ("bounces with e = %g, %s", e, method{1}), ...
                   any (strfind (said, "comes faster and faster")));
    end
  end
end

## floors that are no round numbers: the last bounces drown in the rounding of the place
function floors ()
  m = gsmbp_fixture ("user_floor");
  for e = [0.1 0.8]
    for method = {"dp853", "rk4", "radau", "gauss", "cvode"}
      of = gsmbp_set (m, "e", e);
      said = gsmbp_complaint (@() gsmbp_simulate (of, [2 0], [0 20], "method", method{1}, ...
                                                  "step", 0.02));
      gsmbp_check (sprintf ("bounces on a floor with e = %g, %s", e, method{1}), ...
                   any (strfind (said, "event, hit, failed")));
    end
  end
end

## s = t^4/12 has no event at 0, where it is flat, whatever a polynomial makes of it
function from_rest ()
  m = gsmbp_fixture ("user_flat");
  for method = {"dp853", "rk4", "radau", "gauss", "cvode"}
    r = gsmbp_simulate (m, [0 0], 0:0.1:1, "method", method{1});
    gsmbp_check (["no event where a motion begins flat, " method{1}], numel (r.events.t), 0);
    gsmbp_check (["... nor another motion, " method{1}], r.x(end,1) - 1 / 12, 1e-9);
  end
end

## from rest at amplitude a: it passes the lowest position every half period
function pendulum ()
  m = gsmbp_fixture ("user_section");
  a = 1.2;
  period = 4 * ellipke (sin (a / 2) ^ 2) / sqrt (9.81);
  for method = {"dp853", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [a 0], [0 20], "rtol", 1e-13, "atol", 1e-14, "method", method{1}, ...
                        "step", 0.005);
    at = r.events.t(strcmp (r.events.name, "section"));
    near = 1e-11 + 1e-9 * strcmp (method{1}, "cvode");
    gsmbp_check (["sections of a pendulum, " method{1}], ...
                 at - (period * (1:2:2*numel (at))' / 4), near);
    turns = r.events.t(strcmp (r.events.name, "turn"));
    gsmbp_check (["turns that end a swing, " method{1}], ...
                 turns - period * (1:numel (turns))', 10 * near);
    gsmbp_check (["no section twice, none missed, " method{1}], ...
                 numel (at) == floor (20 / period * 2 + 0.5));
  end
  gsmbp_check ("a threshold that is not reached does not end it", ...
                 isempty (r.stats.stopped));
  r = gsmbp_simulate (m, [a 0], [0 25], "method", "gauss", "step", 0.005);
  gsmbp_check ("sections are beside the steps of gauss: it keeps its energy", ...
                 r.x(end,2) ^ 2 / 2 - 9.81 * (cos (r.x(end,1)) - cos (a)), 1e-13);
  gsmbp_check ("... and makes as many of them", r.stats.accepted - 5000, 0);
  r = gsmbp_simulate (m, [a 4], [0 20], "rtol", 1e-12);
  gsmbp_check ("the end is at the threshold", ...
                 r.x(end,1) - (100 * pi / 180), 1e-12);
  ## energy: phi_d^2/2 - g cos (phi)
  gsmbp_check ("its speed", ...
                 r.x(end,2) - (sqrt (16 + 2 * 9.81 * (cos (100 * pi / 180) - cos (a)))), 1e-10);
  r = gsmbp_simulate (m, [2 0.1], [0 0.005]);
  gsmbp_check ("what is true at the start is no event", ...
                 isempty (r.events.t));
end

## closed loops: a reset of an independent speed keeps them closed, in every way of the loops; one
## that they do not leave free is refused
function crank ()
  m = gsmbp_fixture ("user_crank");
  x0 = gsmbp_assemble (m, [0.5 -0.6 0.38 3 0 0]);
  alone = gsmbp_simulate (m, x0, [0 1]);
  for method = {"dp853", "radau", "gauss", "cvode"}
    for way = {"projection", "partitioning", "baumgarte"}
      r = gsmbp_simulate (m, x0, [0 1], "loops", way{1}, "method", method{1});
      what = [method{1} ", " way{1}];
      gsmbp_check (["one kick, " what], numel (r.events.t) == 1);
      gsmbp_check (["all speeds twice as fast, " what], ...
                   r.events.after(1,4:6) - 2 * r.events.before(1,4:6), 1e-8);
      gsmbp_check (["at the same time, " what], r.events.t - alone.events.t, 1e-8);
      gsmbp_check (["to the same end, " what], r.x(end,:) - alone.x(end,:), 1e-6);
    end
  end
  ## when it comes there: told by a reset that changes nothing
  there = gsmbp_simulate (gsmbp_set (m, "early", 2, "kicked", 1), x0, [0 2]).events.t;
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    said = gsmbp_complaint (@() gsmbp_simulate (gsmbp_set (m, "early", 20, "late", 2), x0, ...
                                                [0 2], "method", method{1}));
    at = regexp (said, "an event, bad, failed .* at t = (\\S+) s: .* loops do not leave", ...
                 "tokens", "once");
    gsmbp_check (["a reset that loops do not leave, " method{1}], numel (at) == 1);
    gsmbp_check (["... and when, " method{1}], str2double (at) - there, 1e-7);
  end
  ## at the last instant; methods whose steps are the same bits with that event and without
  for method = {"dp853", "rk4", "gauss"}
    o = {x0, [0 0.5], "method", method{1}};
    last = gsmbp_simulate (gsmbp_set (m, "early", 20), o{:}).x(end,1);
    said = gsmbp_complaint (@() gsmbp_simulate (gsmbp_set (m, "early", 20, "late", last), o{:}));
    gsmbp_check (["... and at the last instant, " method{1}], ! isempty (strfind (said, ...
                 "an event, bad, failed with INFO = 12 at t = 0.5 s")));
  end
end

## runs of an ensemble as single ones; those that an event ends stay there
function many ()
  m = gsmbp_fixture ("user_bounce");
  restitution = [0.75 0.8 0.9 0.95];
  e = gsmbp_ensemble (m, [1 0], 0:0.5:5, "parameters", struct ("e", restitution));
  for i = 1:4
    r = gsmbp_simulate (gsmbp_set (m, "e", restitution(i)), [1 0], 0:0.5:5);
    gsmbp_check (sprintf ("run %d as alone", i), ...
                 e.x(1:rows (r.x)-1,:,i) - r.x(1:end-1,:), 1e-12);
    gsmbp_check (sprintf ("run %d stays at its end", i), ...
                 [e.final(i,:) - r.x(end,:), e.reached(i) - 3], 1e-12);
    mine = e.events.run == i;
    gsmbp_check (sprintf ("run %d has the events that it has alone", i), ...
                 isequal ([e.events.number, e.events.mode](mine,:), ...
                          [r.events.number, r.events.mode]) ...
                 && all (abs (e.events.t(mine) - r.events.t) < 1e-12));
  end
  gsmbp_check ("they are at their ends", e.ok);
  w = gsmbp_sweep (m, [1 0], 0:0.5:5, "vary", struct ("e", [0.75 0.95]), "plan", "grid", ...
                   "keep", {"first hit", "last hit", "count hit", "count done"});
  for i = 1:2
    t = e.events.t(e.events.run == [1, 4](i) & e.events.number == 1);
    gsmbp_check ("a sweep keeps when the first one was, and the last, how many there were", ...
                 w.values(i,2:5) - [sqrt(2 / m.par.g), t(end), numel(t), 1], 1e-9);
  end
  never (m);
  e = gsmbp_ensemble (m, [1 0], 0:0.5:5, "parameters", struct ("e", [0.5 0.8]));
  gsmbp_check ("one whose bounces accumulate fails, whatever comes then", e.ok' == [false, true]);
end

## a clock kicks what rests on a stop
function kicked ()
  m = gsmbp_fixture ("user_kick");
  methods_ = {"dp853", "radau", "cvode"};
  for method = methods_(1:2+gsmbp_has_sundials ())
    kicks = at = [];
    for tk = [4.1:0.35:7, 5]
      r = gsmbp_simulate (gsmbp_set (m, "tk", tk), m.initial, [0, tk + 0.2], "method", ...
                          method{1}, "rtol", 1e-10, "atol", 1e-10);
      kicks(end+1) = sum (strcmp (r.events.name, "kick"));
      at(end+1) = r.x(end,1);
    end
    gsmbp_check ([method{1} ": one kick each from a rest"], all (kicks == 1));
    gsmbp_check ([method{1} ": up from there"], max (abs (at - (4 * 0.2 - 9.81 * 0.02))), 1e-7);
  end
end

## output times where the events of a run before were
function again ()
  m = gsmbp_fixture ("user_governor");
  x0 = gsmbp_assemble (m, m.initial, "hold", "th");
  x0(4) = 10;
  x0 = gsmbp_assemble (m, x0, "hold", "th");
  told = [];
  for step = linspace (2.6e-3, 3e-3, 20)
    run = @(t) gsmbp_simulate (m, x0, t, "input", 1, "method", "gauss", "step", step);
    at = run ([0 2]).events.t';
    told(end+1) = numel (run (unique ([0 at 2])).events.t) - numel (at);
  end
  gsmbp_check ("gauss: the same events with rows at them", all (told == 0));
end

## 101 events at one instant end a run, and the error names the reason and the time
function too_many ()
  m = gsmbp_fixture ("user_instant");
  text = gsmbp_complaint (@() gsmbp_simulate (m, [0 2], [0 1]));
  gsmbp_check (["too many events: " text], ...
               ! isempty (regexp (text, 't = 0\.5\d* s.*more than 100 events at one instant')));
end
