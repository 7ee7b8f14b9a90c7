## [text, misses] = peers_table (s, w, notes): the least time of each within every error from 1e-3
## to 1e-12, as text, and where GSMBP's is not the least.

function [text, misses] = peers_table (s, w, notes)
  names = {w.who};
  names(strcmp (names, "CasADi")) = {"CasADi's code, same integrator"};
  others = setdiff (unique (names, "stable"), {"GSMBP"}, "stable");
  groups = unique (cellfun (@group, others, "UniformOutput", false), "stable");
  of = cellfun (@group, names, "UniformOutput", false);
  text = sprintf ("\n## %s, %g s\n\n| error | GSMBP, us | by |%s\n|---|---|---|%s\n", s.name, ...
                  s.end, sprintf (" %s |", groups{:}), repmat ("---|", 1, numel (groups)));
  misses = {};
  for error = 10 .^ -(3:12)
    [ours, by] = least (w(strcmp (names, "GSMBP")), error);
    text = [text, sprintf("| %.0e | %.1f | %s |", error, 1e6 * ours, by)];
    for g = groups
      theirs = least (w(strcmp (of, g{1}) & ! strcmp (names, "GSMBP")), error);
      text = [text, sprintf(" %s |", ratio (theirs / ours))];
      if (theirs <= ours)
        misses{end+1} = sprintf ("%s on %s at %.0e", g{1}, s.name, error);
      end
    end
    text = [text, "\n"];
  end
  text = [text, sprintf("\n* %s", notes{:}), "\n"];
end

## SciPy by the right-hand side, others by themselves
function name = group (who)
  name = regexprep (who, '^(SciPy) \S+ (on .*)$', '$1 $2');
  if (strcmp (name, who))
    name = regexprep (who, '^(MuJoCo|Drake) .*$', '$1');
  end
end

function text = ratio (r)
  text = sprintf ("%.3g", r);
  if (! isfinite (r))
    text = "-";
  end
end

function [seconds, by] = least (w, error)
  fit = w([w.error] <= error);
  [seconds, by] = deal (Inf, "-");
  if (! isempty (fit))
    [seconds, k] = min ([fit.seconds]);
    by = sprintf ("%s %.2g", strtrim (fit(k).method), fit(k).setting);
  end
end
