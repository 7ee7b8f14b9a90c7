## [text, id] = gs.run.failure_text (m, text, info, stats, last)
## Why a run of the model M, which has its parameters, ended: TEXT of the engine and what its LAST
## state adds, a struct with x and v (empty where there is none).  INFO, STATS: how it ended
## (share/engine/core/gsmbp/statistics.h).  ID: that of an error that says so.

function [text, id] = failure_text (m, text, info, stats, last)
  id = "gsmbp:info";
  if (info == 3 && stats.failed == 8)
    if (stats.failed_info < 4)
      id = "gsmbp:start";
      text = [text, dependent_rows(m, stats.reached, last)];
    endif
    return;
  endif
  text = [text, fastest(m, stats.reached, last, info), ...
          no_derivative(m, stats.reached, last, info)];
endfunction

## the rows of the constraints that are dependent in the LAST state
function text = dependent_rows (m, t, last)
  text = "";
  if (isempty (last))
    return;
  endif
  d = m.sizes;
  [~, ~, H] = m.con (t, last.x(1:d.nq), last.x(d.nq + (1:d.nu)));
  [U, S] = svd (H);
  s = [diag(S); zeros(d.nlam - min (size (S)), 1)];
  lost = s <= 1e-3 * max (s);
  names = gs.text.constraint_names (m);
  names = names(any (abs (U(:,lost)) > 0.1, 2));
  text = ["; found in rows " strjoin(names', ", ")];
endfunction

## the state that changes fastest beside its size, where the steps or the numbers gave out
function text = fastest (m, t, last, info)
  text = "";
  if (isempty (last) || ! any (info == [2, 4, 6, 8]) || ! any (strcmp (m.subroutines, "rhs")))
    return;
  endif
  [rate, ~] = m.rhs (t, last.x, last.v);
  share = abs (rate) ./ max (m.nominal, abs (last.x));
  share(! isfinite (share)) = Inf;
  [~, k] = max (share);
  unit = {m.units.states{k}, "1"}{1 + isempty(m.units.states{k})};
  per_second = regexprep ([unit "/s"], "/s/s$", "/s^2");
  text = sprintf ("; there %s = %.6g %s has the rate %.6g %s%s", m.states{k}, last.x(k), unit,
                  rate(k), per_second, gs.text.not_finite_value (rate(k)));
endfunction

## the derivative that an implicit method lacks, where the rates are finite
function text = no_derivative (m, t, last, info)
  text = "";
  if (isempty (last) || info != 6 || ! any (strcmp (m.subroutines, "jac")))
    return;
  endif
  [rates, ~] = m.rhs (t, last.x, last.v);
  if (! all (isfinite (rates)))
    return;
  endif
  [A, ~, ~, ~, ~] = m.jac (t, last.x, last.v);
  text = gs.text.not_finite_entries (A, strcat ({"rate of "}, m.states(:)), m.states);
  text = [merge(isempty (text), "", "; "), text];
endfunction
