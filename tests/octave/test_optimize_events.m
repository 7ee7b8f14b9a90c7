## gsmbp_optimize over runs with events of the scene: a ball that is to be at a height behind a
## bounce; runs that an event ends, with the end's own time; slopes of words as prices of
## equations, beside differences.

function test_optimize_events ()
  if (! gsmbp_has_nlopt ())
    printf ("ok left out: libnlopt-dev is not installed\n");
    return;
  end
  m = gsmbp_fixture ("sensitivity_bounce");
  bounce (m);
  top (m);
  slopes (m);
end

## height 0.4 at 1 s from 1 m: y = lo + e*g*fall*d - g*d^2/2, d = 1 - fall
function bounce (m)
  r = gsmbp_optimize (m, {"e", 0.7, [0.5 0.95]}, {"value", "e"}, {"end", "y", "=", 0.4}, ...
                      {"run", [0 0.5 1], [1; 0]});
  fall = sqrt (2 * 0.9 / 9.81);
  e = (0.3 + 9.81 / 2 * (1 - fall) ^ 2) / ((1 - fall) * 9.81 * fall);
  gsmbp_check ("restitution for a height", r.values.e - e, 1e-9);
  gsmbp_check ("with exact derivatives", strcmp (r.derivatives, "exact"));
end

## the end that is as high as possible, by its place and by the integral of its speed; the earliest
## one that is high enough, with derivatives and by differences
function top (m)
  run = {"run", 0:0.05:1, [1; 3]};
  free = {"last", 0.2, [0.1 0.5]};
  for goal = {{"end", "y", -1}, {"integral", "y_d", -1}}
    r = gsmbp_optimize (m, free, goal{1}, {}, run);
    gsmbp_check (["the top, by " goal{1}{1}], r.values.last - 3 / 9.81, 1e-9);
    gsmbp_check ("exact, as many rows as times", strcmp (r.derivatives, "exact") ...
                 && rows (r.results.case1.x) == 21 && r.results.case1.t(end) == r.values.last);
  end
  early = (3 - sqrt (9 - 2 * 9.81 * 0.4)) / 9.81;
  models = {m, gsmbp_fixture("user_bounce")};
  for k = 1:2
    r = gsmbp_optimize (models{k}, free, {"end", "end_time"}, {"end", "y", ">", 1.4}, run);
    gsmbp_check ("the earliest end above 1.4 m", r.values.last - early, 1e-8);
    gsmbp_check ("what the derivatives are is said", strcmp (r.derivatives, "exact") == (k == 1));
  end
end

## of words by the end and by a start, as prices of equations
function slopes (m)
  run = {"run", 0:0.05:1, [1; 3], "target", struct("y", @(t) 0.2 + t .^ 2), "band", 0.9};
  best = @(word, last, v) gsmbp_optimize (m, {"last", last, [0.1 0.9]; "y_d", v, [2 5]}, ...
                                          {word, "error.y"}, {"value", "last", "=", last; ...
                                          "value", "y_d", "=", v}, run);
  for word = {"end", "rms", "settling"}
    f = @(s) best (word{1}, 0.37 + s(1), 3 + s(2)).J;
    d = @(s) (8 * (f (s) - f (-s)) - (f (2 * s) - f (-2 * s))) / (12 * max (s));
    found = [best(word{1}, 0.37, 3).active.multiplier];
    gsmbp_check (["slopes of " word{1}], found - [d([1e-3, 0]), d([0, 1e-3])], 1e-8);
  end
end
