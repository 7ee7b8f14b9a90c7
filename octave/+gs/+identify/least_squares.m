## f = gs.identify.least_squares (who, A, b, names)
## Least squares of A*p = b by QR of the columns scaled to length 1: p, covariance for rows of
## variance 1, the triangle R and z with norm (A*p - b)^2 = norm (R*p - z)^2 + rss, condition
## numbers as it stands and scaled.  Columns that the rows do not tell apart are an error of WHO
## that names them.

function f = least_squares (who, A, b, names)
  scale = norm (A, "columns");
  missing = find (scale == 0);
  if (! isempty (missing))
    error ("%s: the data do not depend on %s: fix it (option fixed), or move other axes", who, ...
           strjoin (names(missing)(:)', ", "));
  elseif (rows (A) < columns (A))
    error ("%s: %d rows are too few for %d parameters", who, rows (A), columns (A));
  endif
  [Q, R] = qr (A ./ scale, 0);
  [~, S, V] = svd (R);
  s = diag (S);
  f.condition_scaled = s(1) / s(end);
  if (f.condition_scaled > 1e10)
    loose = V(:,s < 1e-10 * s(1));
    which = find (max (abs (loose), [], 2) > 1e-3);
    error (["%s: the data do not tell %s apart (condition %.1e): fix some of them (option " ...
            "fixed), or excite them (gsmbp_excite)"], who, strjoin (names(which)(:)', ", "), ...
           f.condition_scaled);
  endif
  z = Q' * b;
  f.p = (R \ z) ./ scale';
  half = (R \ eye (columns (A))) ./ scale';
  f.covariance = half * half';
  f.condition = cond (A);
  [f.R, f.z] = deal (R .* scale, z);
  f.residual = b - A * f.p;
  f.rss = sumsq (f.residual);
endfunction
