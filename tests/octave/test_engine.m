## Both run times, GSMBP_ENGINE=c and fortran, integrate alike: INFO, events, calls; states differ
## by rounding at most. In quad precision, with derivatives, and where a run is ended by its timeout
## or by an error of its input, too; one run may be within the input of another. Another word is
## refused.

function test_engine ()
  before = getenv ("GSMBP_ENGINE");
  unwind_protect
    for name = {"case_03a", "event_arm", "sampled_crank", "sensitivity_clock"}
      m = gsmbp_fixture (name{1});
      for method = {"dp853", "rk4", "auto"}
        alike ([name{1} " " method{1}], m, {"method", method{1}}, 1e-8);
      end
    end
    alike ("sensitivity_clock, derivatives", m, {"sensitivity", m.json.sensitivity{1}}, 1e-8);
    quad = gsmbp_fixture ("case_03a", "precision", "quad");
    for method = {"dp853", "rk4"}
      alike (["quad " method{1}], quad, {"method", method{1}}, 1e-15);
    end
    ended (gsmbp_fixture ("case_03a"));
    within (gsmbp_fixture ("case_03a"));
    setenv ("GSMBP_ENGINE", "c99");
    gsmbp_check ("another word", strcmp (gsmbp_complaint (@() of (m, {})), ...
      ["gsmbp_simulate: GSMBP_ENGINE: expected c or fortran; found \"c99\"; " ...
       "unsetenv (\"GSMBP_ENGINE\") takes the default"]));
  unwind_protect_cleanup
    setenv ("GSMBP_ENGINE", before);
  end_unwind_protect
end

function [r, info] = of (m, options, seconds = 0.5)
  if (m.sizes.nlam > 0)
    options = [options, {"start", "project"}];
  end
  [r, info] = gsmbp_simulate (m, m.initial, linspace (0, seconds, 6), options{:});
end

function alike (what, m, options, tolerance)
  setenv ("GSMBP_ENGINE", "fortran");
  [a, info] = of (m, options);
  setenv ("GSMBP_ENGINE", "c");
  [b, same] = of (m, options);
  counts = @(r) [r.stats.calls, r.stats.accepted, r.stats.rejected, r.stats.projections];
  gsmbp_check ([what ": INFO, counts"], isequal ({info, counts(a)}, {same, counts(b)}));
  if (isfield (a, "events"))
    gsmbp_check ([what ": events"], isequal (a.events.number, b.events.number));
    gsmbp_check ([what ": their times"], [0; a.events.t - b.events.t], tolerance);
  end
  gsmbp_check ([what ": states"], max (abs (a.x - b.x)) ./ max (1, max (abs (a.x))), tolerance);
  if (isfield (a, "dx"))
    [x, y] = deal (struct2cell (a.dx){1}, struct2cell (b.dx){1});
    gsmbp_check ([what ": derivatives"], max (abs (x - y)) ./ max (1, max (abs (x))), tolerance);
  end
end

## by the run time in C: the last state is that of the time reached
function ended (m)
  setenv ("GSMBP_ENGINE", "c");
  for method = {"dp853", "rk4"}
    [r, info] = of (m, {"method", method{1}, "maxstep", 1e-5, "timeout", 0.2}, 1e4);
    gsmbp_check (["timeout, " method{1}], info == 10 && strcmp (r.stats.stopped, "timeout") ...
                 && r.stats.reached > 0 && r.stats.seconds < 2);
    text = gsmbp_complaint (@() of (m, {"method", method{1}, "input", @(t, x) late(t, m)}));
    gsmbp_check (["an error of the input, " method{1}], ! isempty (strfind (text, "too late")));
  end
end

## a function of inputs may simulate the same model itself
function within (m)
  for engine = {"c", "fortran"}
    setenv ("GSMBP_ENGINE", engine{1});
    for method = {"dp853", "rk4", "radau"}
      [one, two] = deal (of (m, {"method", method{1}, "input", @(t, x) pushed (t, m)}, 0.01), ...
                         of (m, {"method", method{1}, "input", @(t, x) looked (t, m)}, 0.01));
      gsmbp_check (sprintf ("a run within the input of another, %s, %s", engine{:}, method{1}), ...
                   isequal (one.x, two.x) && isequal (one.v, two.v));
    end
    text = gsmbp_complaint (@() of (m, {"input", @(t, x) looked (t, m, @(t, x) late (1, m))}));
    gsmbp_check (["an error of the input of that, " engine{1}], any (strfind (text, "too late")));
  end
end

function v = pushed (t, m)
  v = (1 + t) * ones (m.sizes.nv, 1);
end

function v = looked (t, m, input = @(t, x) pushed (0, m))
  of (m, {"input", input}, 1e-3);
  v = pushed (t, m);
end

function v = late (t, m)
  if (t > 0.1)
    error ("too late");
  end
  v = zeros (m.sizes.nv, 1);
end
