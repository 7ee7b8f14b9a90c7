## [f, F] = gs.optimize.measure_word (word, y, Y, R, D, band)
## What a word says of a quantity Y over the times of a load case R, and its derivatives from those
## of the quantity, a row for each number: "each" one for each time, else one.  D: those of the
## times and weights of R, if they have any.  The words are listed in the help of gsmbp_optimize.
## Without arguments: all of them.

function [f, F] = measure_word (word, y, Y, R, D, band)
  if (nargin == 0)
    f = {"start", "end", "mean", "integral", "drawn", "square", "rms", "peak", "max", "min", ...
         "each", "settling", "value", "mass"};
    return;
  endif
  w = R.w(:)';
  T = sum (w);
  W = by_variables (D, "w", size (Y));
  one = @(k) deal (y(k), Y(k,:));
  switch (word)
    case "start"
      [f, F] = one (1);
    case "end"
      [f, F] = one (numel (y));
    case "mean"
      f = w * y / T;
      F = (w * Y + (y - f)' * W) / T;
    case "integral"
      [f, F] = deal (w * y, w * Y + y' * W);
    case "drawn"
      [f, F] = deal (w * max (y, 0), w * ((y > 0) .* Y) + max (y, 0)' * W);
    case {"square", "rms"}
      f = w * y .^ 2 / T;
      F = (w * (2 * y .* Y) + (y .^ 2 - f)' * W) / T;
      if (strcmp (word, "rms"))
        [f, F] = deal (sqrt (f), F / (2 * max (sqrt (f), realmin)));
      endif
    case "peak"
      [~, k] = max (abs (y));
      [f, F] = deal (abs (y(k)), sign (y(k)) * Y(k,:));
    case "max"
      [~, k] = max (y);
      [f, F] = one (k);
    case "min"
      [~, k] = min (y);
      [f, F] = one (k);
    case "each"
      [f, F] = deal (y, Y);
    case "settling"
      [f, F] = settling (y, Y, R.t(:), by_variables (D, "t", size (Y)), band);
  endswitch
endfunction

## derivatives of times or weights, columns by the variables
function W = by_variables (D, name, sizes)
  W = zeros (sizes);
  if (isfield (D, name))
    W = reshape (D.(name), sizes);
  endif
endfunction

## when |y| last leaves the band, beside its first value, from the first time on: on a line
## between two times
function [f, F] = settling (y, Y, t, T, band)
  limit = band * abs (y(1));
  L = band * sign (y(1)) * Y(1,:);
  k = find (abs (y) > limit, 1, "last");
  F = zeros (1, columns (Y));
  if (isempty (k))
    f = 0;
  elseif (k == numel (y))
    ## not yet: the time goes on as far as it is outside
    f = t(end) - t(1) + (abs (y(k)) / max (limit, realmin) - 1) * (t(end) - t(1));
    F = (t(end) - t(1)) * (sign (y(k)) * Y(k,:) / limit - abs (y(k)) * L / limit ^ 2) ...
        + f / (t(end) - t(1)) * T(end,:);
  else
    a = abs (y(k)) - limit;
    b = limit - abs (y(k+1));
    A = sign (y(k)) * Y(k,:) - L;
    B = L - sign (y(k+1)) * Y(k+1,:);
    h = t(k+1) - t(k);
    f = t(k) - t(1) + h * a / (a + b);
    F = h * (A * b - a * B) / (a + b) ^ 2 + T(k,:) + (T(k+1,:) - T(k,:)) * a / (a + b);
  endif
endfunction
