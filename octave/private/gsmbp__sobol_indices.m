## [first, total] = gsmbp__sobol_indices (values, k)
## The indices of Sobol of K parameters, a row each, for the columns of VALUES, which stand in the
## arrangement of Saltelli: A, B, then A with one column of B after the other.  Saltelli and others
## (2010), table 2: (b) for the first order, (f), Jansen's, for the total; samples with a run that
## failed are left out.

function [first, total] = gsmbp__sobol_indices (values, k)
  n = rows (values) / (k + 2);
  v = permute (reshape (values, n, k + 2, columns (values)), [1, 3, 2]);
  v = v(all (all (isfinite (v), 3), 2),:,:);
  [a, b] = deal (v(:,:,1), v(:,:,2));
  variance = var ([a; b], 1, 1);
  [first, total] = deal (NaN (k, columns (values)));
  for j = 1:k
    c = v(:,:,2+j);
    first(j,:) = mean ((b - mean ([a; b], 1)) .* (c - a), 1) ./ variance;
    total(j,:) = mean ((a - c) .^ 2, 1) / 2 ./ variance;
  endfor
endfunction
