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
