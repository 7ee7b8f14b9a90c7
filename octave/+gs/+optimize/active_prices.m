## [active, off] = gs.optimize.active_prices (P, q, r)
## Active bounds and demands at the end of a solution R of the problem Q, a struct array: text, kind
## (bound, demand), value, bound, multiplier (how much the goal would fall for each unit that the
## bound is loosened).  OFF: what is left of the gradient of the goal beside it (least squares
## over the active ones).

function [active, off] = active_prices (P, q, r)
  n = numel (r.z);
  near = 1e-6;
  N = zeros (n, 0);
  active = struct ("text", {}, "kind", {}, "value", {}, "bound", {}, "multiplier", {}, "k", {}, ...
                   "sign", {});
  for i = 1:n
    for side = [-1, 1]
      bound = merge (side < 0, q.low(i), q.high(i));
      if (i <= numel (P.free) && abs (r.z(i) - bound) <= near * max (1, abs (bound)))
        f = P.free(i);
        normal = zeros (n, 1);
        normal(i) = -side * f.scale;   # for each unit of the variable itself
        N(:,end+1) = normal;
        active(end+1) = struct ("text", sprintf ("%s %s %g", f.name, "<>"(1 + (side < 0)), ...
                                bound * f.scale), "kind", "bound", "value", r.z(i) * f.scale, ...
                                "bound", bound * f.scale, "multiplier", 0, "k", 0, "sign", 1);
      endif
    endfor
  endfor
  e = r.e;
  for i = 1:numel (e.g)
    for side = [-1, 1]
      bound = merge (side < 0, e.low(i), e.high(i));
      if (! (abs (e.g(i) - bound) <= near * r.size_g(i)) || (side > 0 && equation (P, e, i)))
        continue;
      endif
      N(:,end+1) = -side * e.A(i,:)';
      active(end+1) = of_row (P, e, i, bound);
    endfor
  endfor
  [active, off] = priced (active, N, e.gJ, r.size_J);
endfunction

function a = of_row (P, e, i, bound)
  a = struct ("text", "the values of a peak", "kind", "peak", "value", e.g(i), "bound", bound, ...
              "multiplier", 0, "k", e.row(i), "sign", 1 + equation (P, e, i));
  if (e.row(i) > 0)
    a.text = P.demands(e.row(i)).text;
    a.kind = "demand";
  endif
endfunction

## one that has some room where equations decide all is an equation, too
function is = equation (P, e, i)
  is = e.low(i) == e.high(i) || (e.row(i) > 0 && strcmp (P.demands(e.row(i)).relation, "="));
endfunction

## gJ = N*m, m >= 0 (of equations: any)
function [active, off] = priced (active, M, g, size_J)
  size_ = max (abs (g));
  if (isempty (active))
    off = max ([size_; 0]) / size_J;
    return;
  elseif (isempty (g))   # all is chosen from lists: nothing can give way
    [active.multiplier] = deal (NaN);
    off = 0;
    return;
  endif
  long = max (abs (M), [], 1);
  long(long == 0) = 1;
  M ./= long;
  two = [active.sign] == 2;
  x = nonnegative ([M, -M(:,two)], g);
  m = x(1:columns (M))';
  m(two) -= x(columns (M)+1:end)';
  left = g - M * m';
  off = max (abs (left)) / max (size_J, size_);
  m ./= long;
  for i = 1:numel (active)
    active(i).multiplier = m(i);
  endfor
endfunction

## the least squares solution x >= 0 of A*x = b (Lawson and Hanson 1974)
function x = nonnegative (A, b)
  x = zeros (columns (A), 1);
  in = false (columns (A), 1);
  for k = 1:3 * columns (A)
    w = A' * (b - A * x);
    w(in) = -Inf;
    [most, j] = max (w);
    if (! (most > 1e-10 * max (abs (b))))
      break;
    endif
    in(j) = true;
    do
      s = zeros (size (x));
      s(in) = A(:,in) \ b;
      bad = in & s <= 0;
      if (any (bad))
        step = min (x(bad) ./ (x(bad) - s(bad)));
        x += step * (s - x);
        in &= x > 1e-14;
      endif
    until (! any (bad))
    x = s;
  endfor
endfunction
