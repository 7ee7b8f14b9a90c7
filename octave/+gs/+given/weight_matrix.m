## M = gs.given.weight_matrix (who, name, M, n, least)
## The weight or covariance M, a matrix, a diagonal or a number, as an N x N matrix; an error of WHO
## where it is none, or not above LEAST (0: may be singular, 1: may not).

function M = weight_matrix (who, name, M, n, least)
  given = M;
  if (isscalar (M))
    M = M * eye (n);
  elseif (isvector (M) && numel (M) == n)
    M = diag (M);
  endif
  if (! isequal (size (M), [n n]) || ! all (isfinite (M(:))))
    error ("%s: option %s: expected a number, %d numbers or %d x %d numbers, found %s", who, ...
           name, n, n, n, gs.text.shown_value (size (given)));
  endif
  M = double (M);
  if (norm (M - M', Inf) > 1e-12 * norm (M, Inf))
    [~, k] = max (abs (M - M')(:));
    [i, j] = ind2sub (size (M), k);
    error ("%s: option %s: expected a symmetric matrix, found %g at (%d, %d), %g at (%d, %d)", ...
           who, name, M(i,j), i, j, M(j,i), j, i);
  endif
  M = (M + M') / 2;
  if (n == 0)
    return;
  endif
  smallest = min (eig (M));
  if (smallest < -1e-12 * norm (M) || (least > 0 && smallest <= 0))
    error ("%s: option %s: expected a matrix that is %s, found eigenvalues down to %g", who, ...
           name, {"not negative", "positive"}{1 + (least > 0)}, smallest);
  endif
endfunction
