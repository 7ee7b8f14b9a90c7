## Modes given at the start of a run: those of an earlier run are taken wherever it ended; those
## that contradict the state are an error that names what was expected and found.

function test_event_modes ()
  from_other_runs ();
  rows_at_events (gsmbp_fixture ("event_slide"));
  contradictions ();
  swing ();
  ensembles ();
end

## the modes of run R at its row K
function modes = modes_at (m, r, k)
  in = [m.events.input];
  modes = zeros (size (in));
  modes(in > 0) = r.v(k,in(in > 0));
end

## a row at the time of an event has the mode that is behind it
function rows_at_events (m)
  for method = {"dp853", "radau"}
    o = {"method", method{1}};
    r = gsmbp_simulate (m, [0; 0], [0 4], "input", 0, o{:});
    [t, last] = unique (r.events.t, "last");
    k = find (t > 0, 3);
    again = gsmbp_simulate (m, [0; 0], [0; t(k); 4]', "input", 0, o{:});
    gsmbp_check (["the mode behind an event at a row by " method{1}], ! isempty (k) ...
                 && isequal (again.v(2:end-1,m.events(1).input), r.events.mode(last(k))) ...
                 && isequal (r.events.name, r.events.device));
  end
end

## runs begin where others were, in the middle of sticking, contact and sliding
function from_other_runs ()
  for id = {"stiff", "events"}
    warning ("off", ["gsmbp:" id{1}], "local");
  end
  crank = gsmbp_fixture ("event_crank");
  swing = gsmbp_fixture ("event_swing");
  cases = {gsmbp_fixture("event_slide"), [0; 0], 4, 0
           gsmbp_fixture("event_arm"), [1.5; 0.3; 0; 5], 2, 0
           gsmbp_fixture("event_joint"), [0.3; -0.5; 0.7; 1; -2; 3], 2, [0; 0; 0]
           crank, gsmbp_assemble(crank, crank.initial), 1, 8
           swing, [0.5; -0.2; 3; -4], 1, []
           gsmbp_set(swing, "fc", 0.01), [0; -0.9; 8; 0], 2, []};
  rand ("twister", 7);
  for c = cases'
    [m, x0, last, v] = deal (c{:});
    t = linspace (0, last, 101);
    [stick, slide] = deal (0);
    for method = {"dp853", "rk4", "radau", "gauss"}
      for rtol = [1e-3, 1e-10](1:2 - any (strcmp (method{1}, {"rk4", "gauss"})))
        set_ = {"input", v, "method", method{1}, "rtol", rtol, "step", 5e-3};
        [r, info] = gsmbp_simulate (m, x0, t, set_{:});
        wrong = "";
        for k = 1 + randperm (numel (r.t) - 2)(1:12)
          try
            modes = modes_at (m, r, k);
            stick += any (modes == 0);
            slide += any (modes != 0);
            [n, info] = gsmbp_simulate (m, r.x(k,:)', r.t(k:k+1)', set_{:}, "modes", modes);
            if (info != 0)
              wrong = sprintf ("INFO = %d at %g s", info, r.t(k));
            end
          catch problem
            wrong = problem.message;
          end
        end
        gsmbp_check (sprintf ("%s by %s, %g: its modes are taken %s", m.name, method{1}, rtol, ...
                              wrong), isempty (wrong));
      end
    end
    gsmbp_check ([m.name ": sticking, sliding"], stick > 0 && slide > 0);
  end
end

## each contradiction, with every method
function contradictions ()
  m = gsmbp_fixture ("event_arm");   # S, F1, F2; q2 from -0.5 to 1
  cases = {[0 0.3 1 0], [0 0 0], 'expected 1 of F1, which moves at 1 .*; found 0'
           [0 0.3 -1 0], [0 1 0], 'expected -1 of F1, which moves at -1 .*; found 1'
           [0 0.3 1 0], [0 -1 0], 'expected 1 of F1, which moves at 1 .*; found -1'
           [0 0.3 0 1e-3], [0 0 0], 'expected 1 of F2, which moves at 0.001 .*; found 0'
           [0 0.9 0 0], [1 0 0], 'expected 0 of S, which is at 0.9 between -0.5 and 1 .*; found 1'
           [0 1 0 0], [-1 0 0], 'expected 0 of S, which is at 1 between .*; found -1'
           [0 1 0 -1], [1 0 -1], 'expected 0 of S, which moves at -1 .*; found 1'};
  for method = {"dp853", "rk4", "radau", "gauss", "auto"}
    for c = cases'
      run = @() gsmbp_simulate (m, c{1}, [0 1], "method", method{1}, "modes", c{2});
      said = gsmbp_complaint (run);
      gsmbp_check ([method{1} ": " said], ! isempty (regexp (said, c{3}, "once")));
    end
  end
  [~, info] = gsmbp_simulate (m, [0 1 0 0], [0 0.01], "input", 0, "modes", [1 0 0]);
  gsmbp_check ("at the upper stop, at rest", info == 0);
  [~, info] = gsmbp_simulate (m, [0 0.3 1 -1e-9], [0 0.01], "input", 0, "modes", [0 1 0]);
  gsmbp_check ("sticks but for rounding", info == 0);
  [~, info] = gsmbp_simulate (m, [0 0.3 0 0], [0 0.01], "input", 0, "modes", [0 -1 1]);
  gsmbp_check ("sliding about to begin, both ways", info == 0);
  said = gsmbp_complaint (@() gsmbp_simulate (m, zeros (4, 1), [0 1], "modes", [2 0 0]));
  gsmbp_check (["a number that is no mode: " said], any (strfind (said, "expected 3 numbers, ")));
  q = gsmbp_fixture ("event_arm", "precision", "quad");
  said = gsmbp_complaint (@() gsmbp_simulate (q, cases{1,1}, [0 1], "modes", cases{1,2}));
  gsmbp_check (["in quad precision: " said], ! isempty (regexp (said, cases{1,3}, "once")));
end

## a row that turns: room for the errors of steps, none for what contradicts; an event of the user
function swing ()
  m = gsmbp_fixture ("event_swing");   # F, S, side up and down
  cases = {[0.5 -0.2 1 0], [0 0 0 0], 'expected 1 of F, which moves at 0.928.*; found 0'
           [0.5 -0.2 1 0], [-1 0 0 0], 'expected 1 of F, which moves at 0.928.*; found -1'
           [0 -0.9 2 0], [0 1 0 0], 'expected 0 of S, which is at 0.9 between 0.2 and 1 .*; found 1'
           [0 -1 2 1], [-1 1 0 0], 'expected 0 of S, which moves at -1 .*; found 1'
           [0 -0.9 2 0], [0 0 0 1], 'expected 0 of side, which has no mode; found 1'};
  for c = cases'
    said = gsmbp_complaint (@() gsmbp_simulate (m, c{1}, [0 1], "modes", c{2}));
    gsmbp_check (said, ! isempty (regexp (said, c{3}, "once")));
  end
  said = gsmbp_complaint (@() gsmbp_simulate (m, [0.5 -0.2 1 0], [0 1], "modes", zeros (1, 4), ...
                                        "audit", 1));
  gsmbp_check (["with an audit: " said], ! isempty (regexp (said, cases{1,3}, "once")));
end

## each run by its own start and parameters, in lanes or not; a sweep
function ensembles ()
  m = gsmbp_fixture ("event_crank");   # S, F
  x = gsmbp_assemble (m, [1; -0.5; 0; 0; 0; 0], "hold", "theta");
  y = gsmbp_assemble (m, [x(1:3); 3; 0; 0], "hold", "theta");
  for lanes = [false, true]
    e = gsmbp_ensemble (m, [], [0 0.01], "starts", [x y x]', "modes", [0 0], "lanes", lanes);
    [~, ~, speed] = m.hld (0, y, zeros (3, 1));
    wanted = sprintf (["option modes: expected %d of F, which moves at %.6g (m/s or rad/s); " ...
                       "found 0"], sign (speed(2)), speed(2));
    gsmbp_check (["one start contradicts: " e.reason{2}], isequal (e.ok', [true false true]) ...
                 && strcmp (e.reason{2}, wanted) && isempty ([e.reason{[1 3]}]));
  end
  b = gsmbp_fixture ("event_slider");   # F, S, stops at -hi and hi
  w = gsmbp_sweep (b, [0.05 0], [0 0.01], "vary", struct ("hi", [0.05 0.06]), "plan", "grid", ...
                   "keep", {"final s"}, "modes", [0 1]);
  gsmbp_check (["a sweep: " w.reason{2}], isequal (w.ok', [true false]) ...
               && any (strfind (w.reason{2}, ["expected 0 of S, which is at 0.05 between -0.06 " ...
                                             "and 0.06 (m or rad); found 1"])));
end
