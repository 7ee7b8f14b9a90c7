## Events of the user that only tell: those of an expression up and down follow each other by turns,
## at loose tolerances, too, and each is told once; as many as of an accurate run as long as that
## is the same.

function test_user_alternate ()
  m = gsmbp_fixture ("user_double");
  ## l2, m2, h, g, start: one crossing was told both ways
  cases = {[0.31818752529330746 0.6779929358016864 0.23300337848406144 9.81 ...
            -0.26871695679337348 1.3299251020589438 0.72306282878117467 1.907566804189516], ...
           {"radau", "rtol", 1e-7, "maxorder", 5}
           [0.63291206179169808 1.908875704874933 0.060132628748634231 9.81 ...
            -0.36778560592143639 -0.33250325271898817 -2.2389916474195033 2.9992715785842154], ...
           {"radau", "rtol", 1e-6}};
  rand ("twister", 11);
  for k = 1:6
    cases(end+1,:) = {[0.3 + rand(), 0.1 + 2 * rand(), rand() - 0.5, 9.81, 3 * rand(1, 2) - 1.5, ...
                       6 * rand(1, 2) - 3], {{"radau", "dp853", "gauss"}{1 + rem(k, 3)}, ...
                      "rtol", 10 ^ -(6 + rem (k, 2)), "step", 0.01}};
  end
  for row = cases'
    [c, o] = row{:};
    of = gsmbp_set (m, "l2", c(1), "m2", c(2), "h", c(3), "g", c(4));
    r = gsmbp_simulate (of, c(5:8)', [0 20], "method", o{:});
    e = r.events;
    by = @(names) e.number(ismember (e.name, names));
    what = sprintf ("%s, rtol = %g, %d events", o{1}, o{3}, numel (e.t));
    gsmbp_check ([what ": by turns"], all (diff (by ({"up", "down"}))) ...
                 && all (cellfun (@(n) all (diff (by (n))), {"pass", "turn", "back"})));
    gsmbp_check ([what ": both ways as often as up and down"], ...
                 numel (by ("pass")) - numel (by ({"up", "down"})), 0);
    f = gsmbp_simulate (of, c(5:8)', [0 3], "rtol", 1e-12, "atol", 1e-12).events;
    gsmbp_check ([what ": the first as in an accurate run"], numel (f.t) > 5 ...
                 && isequal (e.number(e.t <= 3), f.number) ...
                 && all (abs (e.t(e.t <= 3) - f.t) < 1e-3));
  end
end
