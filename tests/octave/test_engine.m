## A run that is ended by its timeout or by an error of its input keeps what it has; one run may be
## within the input of another.

function test_engine ()
  m = gsmbp_fixture ("case_03a");
  ended (m);
  within (m);
end

function [r, info] = of (m, options, seconds = 0.5)
  if (m.sizes.nlam > 0)
    options = [options, {"start", "project"}];
  end
  [r, info] = gsmbp_simulate (m, m.initial, linspace (0, seconds, 6), options{:});
end

## the last state is that of the time reached
function ended (m)
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
  for method = {"dp853", "rk4", "radau"}
    [one, two] = deal (of (m, {"method", method{1}, "input", @(t, x) pushed (t, m)}, 0.01), ...
                       of (m, {"method", method{1}, "input", @(t, x) looked (t, m)}, 0.01));
    gsmbp_check (["a run within the input of another, " method{1}], ...
                 isequal (one.x, two.x) && isequal (one.v, two.v));
  end
  text = gsmbp_complaint (@() of (m, {"input", @(t, x) looked (t, m, @(t, x) late (1, m))}));
  gsmbp_check ("an error of the input of that", any (strfind (text, "too late")));
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
