## Events of expressions that pass zero many times within a step of an easy motion: every mark of a
## wheel that turns at a constant speed, by every method, at the times of a closed form.

function test_events_fast ()
  m = gsmbp_fixture ("user_wheel");
  methods_ = {"dp853", "rk4", "radau", "gauss"};
  if (gsmbp_has_sundials ())
    methods_{end+1} = "cvode";
  end
  for method = methods_
    [wrong, off] = deal (0);
    for w = [3, 7.3, 20, 51, 100]
      r = gsmbp_simulate (m, [0 w], [0 5], "method", method{1}, "step", 0.05);
      at = marks (w, 5);
      if (numel (at) == numel (r.events.t))
        off = max (off, max (abs (r.events.t' - at)));
      else
        wrong++;
      end
    end
    gsmbp_check ([method{1} ": all marks of a wheel are told"], wrong == 0);
    gsmbp_check ([method{1} ": their times"], off, 1e-12);
  end
  ensemble (m);
  spindle (methods_(! strcmp (methods_, "gauss")));
  long (m, methods_(! ismember (methods_, {"rk4", "gauss"})));
end

## when sin(3*w*t) rises above 1/2 up to T
function at = marks (w, T)
  at = (pi / 6 + 2 * pi * (0:3*w*T)) / (3 * w);
  at = at(at <= T);
end

## in lanes, too
function ensemble (m)
  w = linspace (3, 60, 50)';
  e = gsmbp_ensemble (m, [], [0 5], "starts", [zeros(50, 1), w]);
  many = accumarray (e.events.run(:), 1, [50, 1]);
  gsmbp_check ("an ensemble in lanes: all marks are told", ...
               e.lanes && isequal (many, arrayfun (@(w) numel (marks (w, 5)), w)));
end

## turns behind a motor, in steps of some seconds: half way between two of them sin(th) is 0 as well
function spindle (methods_)
  m = gsmbp_fixture ("user_spindle");
  for method = methods_
    e = gsmbp_ensemble (m, m.initial, [0 60], "parameters", struct ("J", [5e-4 1e-3 2e-3]), ...
                        "method", method{1});
    gsmbp_check ([method{1} ": all turns of a spindle are told"], all (e.ok) ...
                 && isequal (e.counted.count, floor (e.final(:,1) / (2 * pi))));
    r = gsmbp_simulate (m, m.initial, [0 60], "method", method{1});
    gsmbp_check ([method{1} ": at whole turns"], ...
                 max (abs (r.events.before(:,1)' ./ (2 * pi * (1:numel (r.events.t))) - 1)), 1e-12);
  end
end

## a step of a free wheel might hold thousands of marks
function long (m, methods_)
  for method = methods_
    e = gsmbp_ensemble (m, [0 20], [0 700], "parameters", struct ("J", 1), "method", method{1});
    gsmbp_check ([method{1} ": all marks of a long run are told"], ...
                 e.counted.count == numel (marks (20, 700)));
  end
end
