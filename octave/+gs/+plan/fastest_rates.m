## [x, limited] = gs.plan.fastest_rates (who, s, rows, ends)
## The largest x = s'^2 at the places S that the limits of gs.plan.path_limits allow, from and to
## the values ENDS: backwards the sets from which the end can be reached, then forwards in them,
## with a constant s'' between two places and the limits in the middle.

function [x, limited] = fastest_rates (who, s, rows, ends)
  n = numel (s);
  h = diff (s);
  rows = without_inertia (rows, h);
  ceiling = 1e6 * largest_useful (s, rows);
  top = min (rows.top, ceiling);
  [low, high] = deal (zeros (1, n));
  [low(n), high(n)] = deal (ends(2));
  reachable (who, ends(2), top(n), s(n));
  guess = high(n);
  for k = n-1:-1:1
    [low(k), high(k)] = directly (rows, k, h(k), low(k+1), high(k+1), top(k));
    if (isnan (low(k)) || isnan (high(k)))
      [low(k), high(k)] = before (rows, k, h(k), low(k+1), high(k+1), top(k), guess);
    endif
    guess = high(k);
    if (! (high(k) >= low(k)))
      error (["%s: the limits do not let it pass s = %.9g at any speed: expected a path or " ...
              "limits where %s suffices"], who, s(k), strjoin (rows.names, ", "));
    endif
  endfor
  if (ends(1) < low(1) - 1e-12 || ends(1) > high(1) + 1e-12)
    error (["%s: from the rate %.6g at the start the end cannot be reached: expected one from " ...
            "%.6g to %.6g"], who, sqrt (ends(1)), sqrt (low(1)), sqrt (high(1)));
  endif
  x = zeros (1, n);
  x(1) = ends(1);
  limited = cell (1, n - 1);
  for k = 1:n-1
    [x(k+1), limited{k}] = after (rows, k, h(k), x(k), low(k+1), high(k+1));
  endfor
endfunction

function reachable (who, x, top, s)
  if (x > top)
    error ("%s: the rate %.6g at the end s = %g is above what the speeds allow, %.6g", ...
        who, sqrt (x), ...
           s, sqrt (top));
  endif
endfunction

## a size of x that is never reached but for the lack of limits
function x = largest_useful (s, rows)
  force = max (abs ([rows.least; rows.largest](isfinite ([rows.least; rows.largest]))));
  x = 1;
  if (! isempty (force) && ! isempty (rows.a))
    x = max (force) * (s(end) - s(1)) / max (1e-12, max (abs (rows.a(:))));
  endif
  x = max (x, max ([rows.top(isfinite (rows.top)), 0]));
endfunction

## In the intervals next to a place where the inertia a of a row changes its sign the row limits x
## alone: there a*s'' is small, and what is left would make s'' anything.
function rows = without_inertia (rows, h)
  n = columns (rows.a);
  for i = 1:numel (rows.least)
    for k = find (rows.a(i,1:end-1) .* rows.a(i,2:end) <= 0)
      near = max (1, k - 2):min (n, k + 3);
      slope = abs (rows.b(i,near)) + abs (rows.d(i,near)) / 2;
      rows.a(i,near(abs (rows.a(i,near)) <= 1.5 * h(near) .* slope)) = 0;
    endfor
  endfor
endfunction

## as `before` where one limit holds from the largest x on, without corners to look for
function [least, largest] = directly (rows, k, h, low, high, top)
  [least, largest] = deal (NaN);
  [x, ~, u, steep] = along (rows, k, -h, high, 0, top);
  if (! steep && isfinite (u) && x <= top)
    largest = x;
  endif
  [up, ~, u] = along (rows, k, h, 0, low, high);
  if (isfinite (u) && u >= 0 && up >= low)
    least = 0;
  endif
endfunction

## the set before the interval k of what leads into [low, high]: least and largest of
## x = xm - h*u with xm, u in the polygon of the limits; d*sqrt(xm) by its tangent
function [least, largest] = before (rows, k, h, low, high, top, guess)
  [least, largest] = deal (0, NaN);
  for sign = [1, -1]
    xm = max (guess, 1e-12);
    for iteration = 1:30
      [A, b] = polygon (rows, k, h, low, high, top, xm);
      [best, point] = corner (A, b, sign * [1, -h]);
      if (isnan (best))
        if (xm <= 1e-12)
          break;
        endif
        xm /= 100;   # far above the root the tangent promises nothing
        continue;
      endif
      old = xm;
      xm = max (point(1), 1e-14 * (1 + guess));
      if (all (rows.d(:,k) == 0) || abs (xm - old) <= 1e-13 * xm)
        break;
      endif
    endfor
    if (sign > 0)
      largest = best;
      if (isnan (best))
        return;
      endif
    elseif (! isnan (best))
      least = max (0, -best);
    endif
  endfor
  if (least < 1e-9 * largest)
    least = 0;
  endif
endfunction

## rows A*[xm; u] <= b
function [A, b] = polygon (rows, k, h, low, high, top, xm)
  root = sqrt (xm);
  slope = rows.b(:,k) + rows.d(:,k) / (2 * root);
  level = rows.c(:,k) + rows.d(:,k) * root / 2;
  A = [slope, rows.a(:,k); -slope, -rows.a(:,k)];
  b = [rows.largest - level; level - rows.least];
  keep = isfinite (b) & (any (A, 2) | b < 0);   # 0 <= b is no limit
  A = [A(keep,:); 1, h; -1, -h; 1, -h; -1, h];
  b = [b(keep); high; -low; top; 0];
endfunction

## the corner of a polygon where c*[xm; u] is largest; NaN where it is empty
function [best, point] = corner (A, b, c)
  scale = max (abs (A), [], 2);
  A = A ./ scale;
  b = b ./ scale;
  n = numel (b);
  [i, j] = pairs_of (n);
  determinant = A(i,1) .* A(j,2) - A(j,1) .* A(i,2);
  fine = abs (determinant) > 1e-13;
  i = i(fine);
  j = j(fine);
  determinant = determinant(fine);
  points = [b(i) .* A(j,2) - b(j) .* A(i,2), A(i,1) .* b(j) - A(j,1) .* b(i)] ./ determinant;
  inside = all (A * points' <= b + 1e-9 * abs (b) + 1e-12 * max (1, abs (A) * abs (points')), 1);
  best = NaN;
  point = [NaN, NaN];
  if (any (inside))
    points = points(inside,:);
    [best, at] = max (points * c');
    point = points(at,:);
  endif
endfunction

function [i, j] = pairs_of (n)
  persistent known = 0 first second
  if (known != n)
    [first, second] = find (tril (true (n), -1));
    known = n;
  endif
  i = first;
  j = second;
endfunction

## The largest x that follows x in the interval k with its step h (below 0: that lies before it),
## from low to high; the row that limits it (0: high does), s'' (NaN: there is none), and whether
## the row is too steep in x to be sure that there is none larger.
function [x, at, u, steep] = along (rows, k, h, x, low, high)
  xm = max ((x + high) / 2, 1e-14);
  a = rows.a(:,k);   # without deal, which costs more than the rest
  b = rows.b(:,k);
  c = rows.c(:,k);
  d = rows.d(:,k);
  straight = ! any (d);
  for iteration = 1:12
    root = sqrt (xm);
    tangent = b + d / (2 * root);
    slope = a + h * tangent;
    level = c + d * root / 2 + x * tangent;
    up = (rows.largest - level) ./ slope;
    down = (rows.least - level) ./ slope;
    above = max (up, down);
    below = min (up, down);
    if (! all (slope))
      above(slope == 0) = Inf;
      below(slope == 0) = -Inf;
    endif
    if (h > 0)
      [u, at] = min ([above; (high - x) / (2 * h)]);
      bad = u < max ([below; (low - x) / (2 * h)]) - 1e-9 * abs (u);
    else
      [u, at] = max ([below; (high - x) / (2 * h)]);
      bad = u > min (above) + 1e-9 * abs (u);
    endif
    old = xm;
    xm = max (x + h * u, 1e-14);
    if (straight || abs (xm - old) <= 1e-13 * xm)
      break;
    endif
  endfor
  steep = at <= numel (a) && abs (h * tangent(at)) > 0.5 * abs (a(at));
  x += 2 * h * u;
  if (at > numel (a))
    at = 0;
  endif
  fixed = slope == 0 & a == 0;
  if (bad || any (level(fixed) > rows.largest(fixed)) || any (level(fixed) < rows.least(fixed)))
    u = NaN;
  endif
endfunction

function [next, limit] = after (rows, k, h, x, low, high)
  [next, at] = along (rows, k, h, x, low, high);
  next = min (max (next, low), high);
  limit = "the end";
  if (at > 0)
    limit = rows.names{at};
  endif
endfunction
