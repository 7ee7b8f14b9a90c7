## w = gsmbp__sweep_statistics (w, table, values, o)
## The result W of a sweep with the statistics of VALUES, what is kept, over the runs that came to
## their end, and the correlation with TABLE, the parameters.

function w = gsmbp__sweep_statistics (w, table, values, o)
  good = values(w.ok,:);
  [w.mean, w.std, w.min, w.max] = deal (NaN (1, columns (values)));
  w.quantiles = NaN (3, columns (values));
  if (! isempty (good))
    [w.mean, w.min, w.max] = deal (mean (good, 1), min (good, [], 1), max (good, [], 1));
    w.quantiles = repmat (good(1,:), 3, 1);
  endif
  if (rows (good) > 1 && ! isempty (good))
    w.quantiles = quantile (good, [0.05, 0.5, 0.95], 1, 7);
    w.std = std (good, 0, 1);
  endif
  w.correlation = NaN (columns (table), columns (values));
  if (rows (good) > 2)
    w.correlation = spearman (table(w.ok,:), good);
  endif
  if (strcmp (o.plan, "indices"))
    [w.first, w.total] = gsmbp__sobol_indices (values, columns (table));
  endif
endfunction
