## [w, out] = gs.sweep.statistics_of (w, table, values, o)
## The result W of a sweep with the statistics of VALUES, what is kept, and the correlation with
## TABLE, the parameters: a column over the runs that came to their end and have a number there (an
## event may never have been).  OUT: of each, how many base samples its indices of Sobol are
## without.

function [w, out] = statistics_of (w, table, values, o)
  n = columns (values);
  [w.mean, w.std, w.min, w.max] = deal (NaN (1, n));
  [w.quantiles, w.correlation] = deal (NaN (3, n), NaN (columns (table), n));
  here = w.ok & ! isnan (values);
  for k = 1:n
    good = values(here(:,k),k);
    if (! isempty (good))
      [w.mean(k), w.min(k), w.max(k)] = deal (mean (good), min (good), max (good));
      w.quantiles(:,k) = good(1);
    endif
    if (numel (good) > 1)
      w.quantiles(:,k) = quantile (good, [0.05, 0.5, 0.95], 1, 7);
      w.std(k) = std (good);
    endif
  endfor
  left = 1:n;
  while (! isempty (left))   # those of the same runs in one go
    same = left(all (here(:,left) == here(:,left(1)), 1));
    if (nnz (here(:,left(1))) > 2)
      w.correlation(:,same) = spearman (table(here(:,left(1)),:), values(here(:,left(1)),same));
    endif
    left = setdiff (left, same);
  endwhile
  out = zeros (1, n);
  if (strcmp (o.plan, "indices"))
    [w.first, w.total, out] = gs.sweep.sobol_indices (values, columns (table));
  endif
endfunction
