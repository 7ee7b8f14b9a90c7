## Events at the edges of runs: at the last time, at the first one, of runs that go on from others.

function test_event_edges ()
  m = gsmbp_fixture ("event_edge");
  methods_ = {"dp853", "rk4", "radau", "gauss", "auto"};
  if (gsmbp_has_sundials ())
    methods_{end+1} = "cvode";
  end
  for method = methods_
    at_the_end (m, method{1});
    chains (m, method{1});
    at_jumps (m, method{1});
    at_instants (gsmbp_fixture ("event_instant"), method{1});
    close_together (m, method{1});
    on_the_surface (m, method{1});
    breakaway (gsmbp_fixture ("event_breakaway"), method{1});
  end
  pulled (gsmbp_fixture ("event_pulled"));
  too_sharp (gsmbp_fixture ("event_pulled"));
  too_sharp_of_many (gsmbp_fixture ("event_pulled"));
  many_runs (m);
  derivatives (m);
end

function n = told (r, name)
  n = nnz (strcmp (r.events.name, name));
end

## A push that is at the beginning exactly what friction can hold, and grows, or does not: by the
## closed form x = k*t^3/(6*m) of what is beyond it.
function breakaway (m, method)
  set_ = {"method", method, "step", 1e-3};
  for k = [0, 1e-3, 1, 100]
    for side = [1, -1]
      r = gsmbp_simulate (gsmbp_set (m, "k", side * k), [0 0], [0 1], "input", 3 * side, set_{:});
      gsmbp_check (sprintf ("%s: a breakaway at the start, %g N/s", method, side * k), ...
                   r.x(end,1) - side * k / 6 / 0.8, 1e-9 * (1 + k));
    end
  end
end

## A block that sticks and slips: where friction falls within a small speed vs the slip is close to
## that of vs = 0, a closed form.  Behind the breakaway the speed is rounding.
function pulled (m)
  p = m.par;
  w = sqrt (p.k / p.m);
  part = atan2 ((p.fs - p.fc) / p.k * w, p.v);
  slip = (2 * pi - 2 * part) / w;
  stick = 2 * (p.fs - p.fc) / p.k / p.v;
  for vs = [1e-7, 3e-8, 1e-8]
    for method = {"dp853", "radau", "auto"}
      r = gsmbp_simulate (gsmbp_set (m, "vs", vs), [0; 0], 0:0.1:10, "method", method{1});
      t = r.events.t;
      gsmbp_check (sprintf ("%s: sticks and slips, vs = %g m/s: events", method{1}, vs), ...
                   numel (t) - 28, 0);
      gsmbp_check ("... breakaway, slip and period of vs = 0, beside sqrt(vs)", ...
                   (t(1:3) - p.fs / p.k / p.v - [0; slip; slip + stick]) / sqrt (vs), 0.2);
    end
  end
end

## where friction falls too steeply for an implicit method the run says so; where it says nothing
## the events are right
function too_sharp (m)
  for c = {"radau", "radau", "radau", "radau", "dp853", "auto"
           1e-8, 1e-8, 1e-9, 1e-10, 1e-10, 1e-10
           1e-6, 1e-9, 1e-10, 1e-12, 1e-6, 1e-10
           true, false, true, true, false, false}
    [method, vs, atol, warns] = c{:};
    lastwarn ("");
    [r, info] = gsmbp_simulate (gsmbp_set (m, "vs", vs), [0; 0], 0:0.1:3, "method", method, ...
                                "atol", atol);
    said = lastwarn ();
    wanted = sprintf ("F falls from its breakaway within vs = %.3g, the tolerance of its", vs);
    gsmbp_check (sprintf ("%s, vs = %g, atol = %g: warned of, or 8 events", method, vs, atol), ...
                 warns == ! isempty (strfind (said, wanted)) ...
                 && (warns || (info == 0 && numel (r.events.t) == 8)));
  end
end

## ... and so do ensembles, sweeps (in chunks, too) and programs of sweeps: which runs, once
function too_sharp_of_many (m)
  vs = [1e-7, 1e-10, 1e-8, 1e-9];
  set_ = {"atol", 1e-12, "method"};
  sweep = [{m, [0 0], 0:0.1:3, "vary", struct("vs", vs), "plan", "grid", "chunk", 1}, set_];
  folder = tempname ();
  tidy = onCleanup (@() confirm_recursive_rmdir (false) || rmdir (folder, "s"));
  for c = {@() gsmbp_ensemble(m, [0 0], 0:0.1:3, "parameters", struct ("vs", vs), set_{:}, "radau")
           @() gsmbp_sweep(sweep{:}, "radau")
           @() gsmbp_sweep(sweep{:}, "radau", "program", folder)
           @() gsmbp_sweep(sweep{:}, "dp853")}'
    lastwarn ("");
    c{1} ();
    wanted = "vs = 1e-10, the tolerance of its speed (atol) is 1e-12 in run 2, the first of 2 such";
    warns = isempty (strfind (func2str (c{1}), "dp853"));
    gsmbp_check (["warned of: " func2str(c{1})], ...
                 ! isempty (strfind (lastwarn (), wanted)) == warns);
  end
end

## a clock at the last time, exact but for no rounding: told, with its time; what it does is in the
## last row; one a unit of rounding behind is not
function at_the_end (m, method)
  set_ = {"method", method, "step", 0.1, "input", 0};
  for late = [0.3, 1, 1 - eps/2]
    r = gsmbp_simulate (gsmbp_set (m, "late", late), [5 1 0.5 0], [0 0.1 late], set_{:});
    gsmbp_check (sprintf ("%s: a clock at the end, %g s", method, late), ...
                 [told(r, "clock") - 1, r.events.t(strcmp (r.events.name, "clock")) - late], 0);
  end
  r = gsmbp_simulate (gsmbp_set (m, "late", 1 + eps), [5 1 0.5 0], [0 1], set_{:});
  gsmbp_check ([method ": one behind it"], told (r, "clock"), 0);
  r = gsmbp_simulate (gsmbp_set (m, "turn", 1), [5 1 0.5 0], [0 0.5 1], set_{:});
  gsmbp_check ([method ": a reset and a switch at the end"], told (r, "kick") == 1 ...
               && isequal (r.x(:,3)', [0.5 0.5 1]) && isequal (r.v', [0 0 3]));
  r = gsmbp_simulate (gsmbp_set (m, "last", 1), [5 1 0.5 0], [0 0.5 1], set_{:});
  gsmbp_check ([method ": a stop at the end: " r.stats.stopped], told (r, "done") == 1 ...
               && strcmp (r.stats.stopped, "event done") && isequal (r.t', [0 0.5 1]) ...
               && all (isfinite (r.x(:))));
end

## a run that goes on from the end of another tells the others of a run over both, none twice, none
## lost; the ends lie where events are, and beside them by rounding
function chains (m, method)
  [twice, lost] = deal (0);
  h = sqrt (2 / m.par.g);
  set_ = {"method", method, "step", 0.1, "input", 0};
  for late = [1, 1 + eps, 0.1 + 0.2, 2/3]
    c = gsmbp_set (m, "late", late);
    for v = [-1, -1/3, -3]
      for T = unique ([1, late, late * (1 - eps), -1/v, h, h*(1 + eps), h*(1 - eps)])
        a = gsmbp_simulate (c, [1 1 v 0], [0 T], set_{:});
        b = gsmbp_simulate (c, a.x(end,:), [T, T + 0.05], set_{:});
        both = gsmbp_simulate (c, [1 1 v 0], [0, T + 0.05], set_{:});
        for name = {"pass", "clock", "hit"}
          d = told (a, name{1}) + told (b, name{1}) - told (both, name{1});
          twice += d > 0;
          lost += d < 0;
        end
      end
    end
  end
  gsmbp_check ([method ": runs that go on: none twice, none lost"], [twice, lost], 0);
end

## an event that an input brings about where it jumps: of two runs that meet there the first tells
## it, with the state and the input behind it; so it is where a clock lies there, too
function at_jumps (m, method)
  push = gsmbp_plan ("table", [0 0.25 0.5 0.75], [0 4 0 5]', 0);
  set_ = {"method", method, "step", 0.1, "input", push};
  for late = [100, 0.75]
    c = gsmbp_set (m, "late", late);
    whole = gsmbp_simulate (c, [1 5 0 0], [0 1], set_{:});
    for T = [0.2, 0.25, 0.3, 0.5, 0.75, 0.8]
      a = gsmbp_simulate (c, [1 5 0 0], [0 T], set_{:});
      b = gsmbp_simulate (c, a.x(end,:), [T 1], set_{:});
      gsmbp_check (sprintf ("%s: runs that meet at %g s, inputs jump, clock at %g s", method, T, ...
                            late), [b.x(end,:) - whole.x(end,:), ...
                                    told(a, "pushes") - (T >= 0.25) - (T >= 0.75), ...
                                    told(b, "pushes") + told(a, "pushes") - 2, ...
                                    told(a, "clock") + told(b, "clock") - (late < 1)], 1e-9);
      if (any (T == [0.25 0.75]))
        gsmbp_check (sprintf ("%s: ... the row at %g s", method, T), ...
                     [a.v(end), a.x(end,3) - a.events.after(end,3)] - [3.5 + 2*T, 0], 1e-15);
      endif
    endfor
  endfor
end

## a switch and a sample at one instant: what lies between the two is no event, what is behind both
## is one, whether two runs meet there or not
function at_instants (m, method)
  set_ = {"method", method, "step", 0.01};
  names = @(r) sort (r.events.name(:))';
  for t1 = [0.5, 0.52]
    c = gsmbp_set (m, "t1", t1);
    whole = gsmbp_simulate (c, m.initial, [0 0.8], set_{:});
    wanted = {{"clock", "sampled", "switched"}, {"between", "clock", "switched"}}{1 + (t1 > 0.5)};
    gsmbp_check (sprintf ("%s: a switch at %g s: %s", method, t1, strjoin (names (whole))), ...
                 isequal (names (whole), wanted));
    for T = [0.25, 0.5, 0.51, 0.52]
      a = b = gsmbp_simulate (c, m.initial, [0 T], set_{:});
      told = names (a);
      if (isempty (a.stats.stopped))
        b = gsmbp_simulate (c, a.x(end,:), [T 0.8], "input", a.v(end,:), "memory", a.memory, ...
                            set_{:});
        told = sort ([told, names(b)]);
      endif
      gsmbp_check (sprintf ("%s: ... as in two runs that meet at %g s", method, T), ...
                   isequal (told, wanted) && isequal (a.memory, a.samples.xk(end,:)') ...
                   && max (abs (b.x(end,:) - whole.x(end,:))) < 1e-9);
    endfor
  endfor
end

## two events at one time but for rounding, and an output there: the run goes on
function close_together (m, method)
  for apart = [0, eps, 4e-15, 1e-13]
    c = gsmbp_set (m, "late", 1 + apart);
    [r, info] = gsmbp_simulate (c, [1 5 -1 0], [0 1 2], "method", method, "step", 0.1, "input", 0);
    gsmbp_check (sprintf ("%s: two events %g s apart at an output", method, apart), ...
                 info == 0 && isequal ([told(r, "pass"), told(r, "clock")], [1 1]));
  end
end

## starts on the surface of an event: it is told where its expression is above 0, by however little,
## and falls, and not where it is 0 or below
function on_the_surface (m, method)
  set_ = {"method", method, "step", 0.1, "input", 0};
  for t0 = [0, 1, -3]
    c = gsmbp_set (m, "late", t0);
    found = [];
    for x = [0.1 + 0.2 - 0.3, 1e-17, 1e-300, 0, -1e-17]
      r = gsmbp_simulate (c, [x 5 -1 0], [t0, t0 + 0.5], set_{:});
      found(end+1) = told (r, "pass");
      gsmbp_check ([method ": ... at the start"], all (abs (r.events.t - t0) < 1e-15));
      gsmbp_check ([method ": ... a clock is not"], told (r, "clock"), 0);
    end
    gsmbp_check (sprintf ("%s: starts at 0 and about, at %g s", method, t0), ...
                 found - [1 1 1 0 0], 0);
  end
  at = @(y, v) told (gsmbp_simulate (m, [5 y 0 v], [0 0.1], set_{:}), "hit");
  gsmbp_check ([method ": a ball that rests, rises or falls at the ground but for rounding"], ...
               [at(0, 1), at(-1e-17, 1), at(1e-17, 1), at(1e-17, -1)] - [0 0 0 1], 0);
end

## ensembles, in lanes and not, and sweeps tell them
function many_runs (m)
  late = [1, 0.5, 1 - eps/2, 1 + eps];
  for method = {"dp853", "rk4", "radau"}
    for lanes = [true, false]
      e = gsmbp_ensemble (m, [5 1 0.5 0], [0 1], "parameters", struct ("late", late), "input", ...
                          0, "lanes", lanes, "method", method{1}, "step", 0.1);
      gsmbp_check ([method{1} ": runs of an ensemble"], all (e.ok) ...
                   && isequal (e.events.run(e.events.number == 2)', [1 2 3]));
    end
  end
  w = gsmbp_sweep (m, [5 1 0.5 0], [0 1], "vary", struct ("last", [0.5, 1, 2]), "plan", "grid", ...
                   "input", 0, "keep", {"count done", "first done", "final x"});
  gsmbp_check ("a sweep: events that stop runs at their end and before", all (w.ok) ...
               && isequal (w.values(:,2)', [1 1 0]));
  gsmbp_check ("... where they are then", w.values(:,4)' - [5.25 5.5 5.5], 1e-12);
end

## their times, and states behind resets, by parameters
function derivatives (m)
  for method = {"dp853", "rk4", "radau", "gauss"}
    r = gsmbp_simulate (m, [5 1 0.5 0], [0 1], "sensitivity", {"late"}, "input", 0, "method", ...
                        method{1}, "step", 0.1);
    gsmbp_check ([method{1} ": the time of a clock at the end by its parameter"], ...
                 r.events.dt.late(strcmp (r.events.name, "clock")) - 1, 1e-12);
    r = gsmbp_simulate (gsmbp_set (m, "turn", 1), [5 1 0.5 0], [0 1], "sensitivity", {"turn"}, ...
                        "input", 0, "method", method{1}, "step", 0.1);
    ## behind the kick at T the speed is 1 + 3 (t - T), the place 5 + T/2 + (t - T): at t = T
    gsmbp_check ([method{1} ": a state behind a reset at the end"], ...
                 r.dx.turn(end,[1 3]) - [-0.5, -3], 1e-12);
  end
end
