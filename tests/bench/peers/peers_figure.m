## peers_figure (file, s, w): time against error, of each group the methods that are the fastest at
## some error.

function peers_figure (file, s, w)
  names = strtrim (strcat ({w.who}, {" "}, {w.method}));
  shown = cell (1, 0);
  for start = {"GSMBP", "CasADi", "SciPy", "MuJoCo", "Drake"}
    of = strncmp (names, start{1}, numel (start{1}));
    shown = [shown, fastest(w(of), names(of), 3)];
  end
  keep = ismember (names, shown) & [w.error] < 1 & isfinite ([w.error]);
  [w, names] = deal (w(keep), names(keep));
  [x, order] = sort ([w.seconds]);
  [w, names] = deal (w(order), names(order));
  y = NaN (numel (w), numel (shown));
  for k = 1:numel (shown)
    of = strcmp (names, shown{k});
    y(of,k) = max ([w(of).error], 1e-16);
  end
  panel = struct ("y", y, "label", "largest error at the end [rad, m]", "style", "linespoints");
  panel.names = shown;
  gsmbp_plot (file, 1e6 * x', panel, ...
              "xlabel", sprintf ("compute time for %g s [us]", s.end), "scale", "loglog", ...
              "title", [s.name ": speed against error"], "head", "microseconds", ...
              "size", [18, 16]);
end

## at most MOST of the names, those that are the fastest at most errors
function chosen = fastest (w, names, most)
  won = {};
  for error = 10 .^ -(2:0.5:13)
    fit = find ([w.error] <= error);
    [~, k] = min ([w(fit).seconds]);
    if (! isempty (k))
      won{end+1} = names{fit(k)};
    end
  end
  chosen = unique (won);
  times = cellfun (@(name) nnz (strcmp (won, name)), chosen);
  [~, order] = sort (times, "descend");
  chosen = reshape (chosen(order(1:min (most, numel (order)))), 1, []);
end
