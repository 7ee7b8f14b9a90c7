## [first, total, out] = gs.sweep.sobol_indices (values, k)
## The indices of Sobol of K parameters, a row each, for the columns of VALUES, which stand in the
## arrangement of Saltelli: A, B, then A with one column of B after the other.  Saltelli and others
## (2010), table 2: (b) for the first order, (f), Jansen's, for the total; samples with a run that
## has no number in a column are left out there, OUT of them; NaN where fewer than 32 are left.

function [first, total, out] = sobol_indices (values, k)
  n = rows (values) / (k + 2);
  v = reshape (values, n, k + 2, columns (values));
  [first, total] = deal (NaN (k, columns (values)));
  out = zeros (1, columns (values));
  for i = 1:columns (values)
    x = v(:,:,i);
    x = x(all (isfinite (x), 2),:);
    out(i) = n - rows (x);
    if (rows (x) < 32)
      continue;
    endif
    [a, b] = deal (x(:,1), x(:,2));
    variance = var ([a; b], 1);
    for j = 1:k
      c = x(:,2+j);
      first(j,i) = mean ((b - mean ([a; b])) .* (c - a)) / variance;
      total(j,i) = mean ((a - c) .^ 2) / 2 / variance;
    endfor
  endfor
endfunction
