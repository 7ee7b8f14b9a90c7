## speed_figures (results, out): OUT/growth.png, time of a call against n, and OUT/error.png, speed
## against error; their numbers beside them as .csv.

function speed_figures (results, out)
  colors = struct ("gsmbp", "#000000", "gsmbp_batch", "#888888", "casadi", "#d62728", ...
                   "pinocchio", "#1f77b4", "mujoco_lean", "#2ca02c", "sympy", "#ff7f0e", ...
                   "yardstick", "#bbbbbb");
  panels = struct ("title", {}, "curves", {});
  for one = ...
      {"spat", "id", "general chain, inverse dynamics"; "spat", "fd", ...
       "general chain, forward dynamics"; "spat", "lin", "general chain, linear model"
             "pend", "id", "planar chain, inverse dynamics"; "pend", "fd", ...
                 "planar chain, forward dynamics"; "pend", "lin", "planar chain, linear model"}'
    list = results(cellfun (@(n) ! isempty (regexp (n, ['^' one{1} '\d+$'])), {results.name}));
    panels = add (panels, one{3}, list, colors, @(s, who) [s.n; median_of(s, who, one{2})]);
  end
  if (! isempty (panels))
    bench_figure (fullfile (out, "growth.png"), panels, "links", "time of a call [ns]");
  end
  panels = struct ("title", {}, "curves", {});
  for one = {"random", "fd", "random states"; "fast", "fd", "speeds of 2e4 rad/s"; "singular", ...
             "fd", "singular poses"}'
    panels = add (panels, one{3}, results, colors, ...
                  @(s, who) [median_of(s, who, one{2}) / s.n; ...
                             worst_of(s, who, one{1}, one{2})]);
  end
  bench_figure (fullfile (out, "error.png"), panels, "time of forward dynamics / links [ns]", ...
                "worst relative error of accelerations", "points");
end

function panels = add (panels, title, list, colors, point)
  curves = struct ("name", {}, "color", {}, "x", {}, "y", {});
  for who = fieldnames (colors)'
    p = arrayfun (@(s) point (s, who{1}), list, "UniformOutput", false);
    p = [p{:}];
    if (! isempty (p) && any (all (isfinite (p))))
      curves(end+1) = struct ("name", strrep (who{1}, "mujoco_lean", "mujoco"), "color", ...
                              colors.(who{1}), "x", p(1,:), "y", p(2,:));
    end
  end
  if (! isempty (curves))
    panels(end+1) = struct ("title", title, "curves", curves);
  end
end

## the faster mode
function t = median_of (s, who, word)
  t = NaN;
  one = speed_pick (s.times, who, "", word);
  if (! isempty (one))
    t = min ([one.median]);
  end
end

function e = worst_of (s, who, kind, word)
  e = NaN;
  one = speed_pick (s.errors(strcmp ({s.errors.kind}, kind)), who, "", word);
  if (! isempty (one))
    e = min ([one.worst]);
  end
end
