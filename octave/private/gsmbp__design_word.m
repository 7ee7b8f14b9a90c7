## [f, F] = gsmbp__design_word (word, y, Y, R, band)
## What a word says of a quantity Y over the times of a load case R, and its derivatives from those
## of the quantity, a row for each number: "each" one for each time, else one.  The words are listed
## in the help of gsmbp_optimize.  Without arguments: all of them.

function [f, F] = gsmbp__design_word (word, y, Y, R, band)
  if (nargin == 0)
    f = {"start", "end", "mean", "integral", "drawn", "square", "rms", "peak", "max", "min", ...
         "each", "settling", "value", "mass"};
    return;
  endif
  w = R.w(:)';
  T = sum (w);
  one = @(k) deal (y(k), Y(k,:));
  switch (word)
    case "start"
      [f, F] = one (1);
    case "end"
      [f, F] = one (numel (y));
    case "mean"
      [f, F] = deal (w * y / T, w * Y / T);
    case "integral"
      [f, F] = deal (w * y, w * Y);
    case "drawn"
      [f, F] = deal (w * max (y, 0), w * ((y > 0) .* Y));
    case "square"
      [f, F] = deal (w * y .^ 2 / T, w * (2 * y .* Y) / T);
    case "rms"
      f = sqrt (w * y .^ 2 / T);
      F = w * (y .* Y) / (T * max (f, realmin));
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
      [f, F] = settling (y, Y, R.t(:), band);
  endswitch
endfunction

## when |y| last leaves the band, beside its first value, from the first time on: on a line
## between two times
function [f, F] = settling (y, Y, t, band)
  limit = band * abs (y(1));
  L = band * sign (y(1)) * Y(1,:);
  k = find (abs (y) > limit, 1, "last");
  F = zeros (1, columns (Y));
  if (isempty (k))
    f = 0;
  elseif (k == numel (y))
    ## not yet: the time goes on as far as it is outside
    f = t(end) - t(1) + (abs (y(k)) / max (limit, realmin) - 1) * (t(end) - t(1));
    F = (t(end) - t(1)) * (sign (y(k)) * Y(k,:) / limit - abs (y(k)) * L / limit ^ 2);
  else
    a = abs (y(k)) - limit;
    b = limit - abs (y(k+1));
    A = sign (y(k)) * Y(k,:) - L;
    B = L - sign (y(k+1)) * Y(k+1,:);
    h = t(k+1) - t(k);
    f = t(k) - t(1) + h * a / (a + b);
    F = h * (A * b - a * B) / (a + b) ^ 2;
  endif
endfunction
