## list = gs.identify.rescaled_efforts (m, w)
## Sentences of the efforts that fit the others much better times a factor: another unit, a wrong
## constant of a motor.  W: what gs.identify.regression_rows gives of the data.  The factor is one
## more unknown of the regression; parameters that both efforts hold tell it.

function list = rescaled_efforts (m, w)
  list = {};
  n = m.sizes.nu;
  at = 1:n * floor (sum (w.group <= n) / n);
  p = struct ("Y", w.Y(at,:), "group", w.group(at), "measured", w.measured(at));
  p.known = p.measured - w.b(at);
  p.size = sqrt (sumsq (reshape (p.measured, n, []), 2) / (numel (at) / n));
  if (n < 2 || any (p.size == 0) || isempty (p.Y))
    return;
  endif
  now = left (p, ones (n, 1));
  [best, said] = deal (0.8 * now, {});
  for g = 1:n
    k = factor (p, g, n);
    if (! (k(g) > 0) || abs (k(g) - 1) < 0.1)
      continue;   # one of the other sign is told as such
    endif
    off = left (p, k);
    if (off < 0.98 * best)
      [best, said] = deal (off, {});
    endif
    if (off < 1.02 * best && off < 0.8 * now)
      said{end+1} = sprintf ("effort.%s times %.3g", m.coordinates{g}, k(g));
    endif
  endfor
  list = gs.identify.better_fit ("the efforts fit each other", said, best, now);
endfunction

## the factor of the effort G, as a column of all: from the regression with the measured effort as a
## column, then by Gauss and Newton with the estimated one, which has no noise
function k = factor (p, g, n)
  k = ones (n, 1);
  own = p.group == g;
  s = p.size(p.group);
  A = [p.Y, -own .* p.measured] ./ s;
  size_ = norm (A, "columns") + realmin;
  k(g) = (A ./ size_ \ ((p.measured .* ! own - p.known) ./ s))(end) / size_(end);
  for turn = 1:3
    [r, Q, s] = rest (p, k);
    c = own .* (k(p.group) .* p.measured ./ s - r);
    c -= Q * (Q' * c);
    k(g) *= 1 - max (min ((c' * r) / (c' * c + realmin), 0.5), -0.5);
  endfor
endfunction

## what is left of all rows, over the sizes of the efforts times K
function [r, Q, s] = rest (p, k)
  s = abs (k(p.group)) .* p.size(p.group);
  [U, S, ~] = svd (p.Y ./ s, "econ");
  Q = U(:,diag (S) > 1e-10 * S(1));
  b = (k(p.group) .* p.measured - p.known) ./ s;
  r = b - Q * (Q' * b);
endfunction

function size_ = left (p, k)
  r = rest (p, k);
  size_ = sqrt (sumsq (r) / numel (r));
endfunction
