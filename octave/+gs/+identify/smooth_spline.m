## s = gs.identify.smooth_spline (t, q, more)
## Smooth the columns of Q, sampled at the times T, by quintic splines of equal intervals: intervals
## (their number), B (gs.identify.spline_basis), c (a column for each of Q), R (R'*R = B'*B), noise
## (the standard deviation of what is left of each).  Akaike's criterion, corrected for few rows,
## takes the number that each column asks for; MORE times the largest of these are used.  [] where
## no number of intervals fits.
## Source: Hurvich and Tsai, Biometrika 76 (1989).

function s = smooth_spline (t, q, more = 1.5)
  n = numel (t);
  most = floor (n / 3) - 5;
  best = Inf (1, columns (q));
  chosen = zeros (1, columns (q));
  m = 2;
  while (m <= most)
    fit = fitted (t, q, m);
    k = m + 6;   # and the variance
    if (! isempty (fit))
      goal = n * log (sumsq (fit.rest) / n + realmin) + 2 * k * n / max (1, n - k - 1);
      better = goal < best;
      best(better) = goal(better);
      chosen(better) = m;
    endif
    m = max (m + 1, round (1.2 * m));
  endwhile
  s = fitted (t, q, min (most, ceil (more * max (chosen))));
  if (isempty (s))
    s = fitted (t, q, max (chosen));
  endif
endfunction

## least squares; [] where an interval has too few times
function s = fitted (t, q, m)
  s = [];
  if (m < 1)
    return;
  endif
  B = gs.identify.spline_basis (t, m);
  [R, fails] = chol (B{1}' * B{1});
  if (fails || min (diag (R)) < 1e-4 * max (diag (R)))
    return;
  endif
  c = R \ (R' \ (B{1}' * q));
  c += R \ (R' \ (B{1}' * (q - B{1} * c)));
  rest = q - B{1} * c;
  noise = sqrt (sumsq (rest) / (rows (q) - m - 5)) + eps * max (abs (q));
  s = struct ("intervals", m, "B", {B}, "c", c, "R", R, "rest", rest, "noise", noise);
endfunction
