## rows = gs.plan.path_limits (who, m, path, planned, limits, s, guess)
## The limits along a path between the places S: least <= a*s'' + b*s'^2 + d*s' + c <= largest
## in the middle of each interval (a, b, c, d: limited quantities x intervals), names of the
## quantities,
## and the largest s'^2 that the limits of speed allow at each place.

function rows = path_limits (who, m, path, planned, limits, s, guess)
  middle = (s(1:end-1) + s(2:end)) / 2;
  [q, dq, ddq] = path_at (path, middle);
  used = any (isfinite ([limits.effort; limits.input]), 2);
  bounds = [limits.effort; limits.input];
  rows.least = bounds(used,1);
  rows.largest = bounds(used,2);
  names = [strcat({"effort of "}, m.coordinates(planned)(:)); m.inputs(:)];
  rows.names = names(used)';
  rows.top = top_of (path, s, limits.speed);
  n = sum (used);
  [rows.a, rows.b, rows.c, rows.d] = deal (zeros (n, numel (middle)));
  rows.singular = [];
  if (n == 0)
    return;
  endif
  few = ! any (isfinite (limits.input(:)));
  at = @(k, rate, second, guess) quantities (who, m, planned, few, guess, q(:,k), ...
                                             dq(:,k) * rate, ...
                                             dq(:,k) * second + ddq(:,k) * rate^2);
  k = 1:numel (middle);
  [f1, guess] = at (k, 1, 0, guess);   # at rate 1, without acceleration
  f1 = f1(used,:);
  [f2, f3, fa] = deal (at (k, 2, 0, guess)(used,:), at (k, 3, 0, guess)(used,:), ...
                       at (k, 1, 1, guess)(used,:));
  rounding = 32 * eps * max (abs (cat (3, f1, f2, f3, fa)), [], 3);   # a coordinate stands still
  rows.a = above (fa - f1, rounding);
  rows.b = above ((f3 - 2 * f2 + f1) / 2, rounding);
  rows.d = above (f2 - f1 - 3 * rows.b, rounding);
  rows.c = f1 - rows.d - rows.b;
  k = 1:16:numel (middle);
  there = at (k, 1.5, -2, guess(:,k))(used,:);
  said = (-2 * rows.a + 2.25 * rows.b + 1.5 * rows.d + rows.c)(:,k);
  off = abs (there - said) > 1e-6 * (abs (f1(:,k)) + abs (there) + abs (rows.a(:,k)));
  for j = find (any (off, 1), 1)
    quadratic (who, m, rows.names(off(:,j)), middle(k(j)));
  endfor
  for i = 1:n
    turned = changes (middle, rows.a(i,:), s);
    rows.singular = [rows.singular, turned];
  endfor
endfunction

## where A changes its sign; not where it is 0 but for rounding on a stretch, where a coordinate
## stands still
function x = changes (middle, a, s)
  k = find (abs (a) > 1e-6 * max (abs (a)));
  [from, to] = deal (k(1:end-1), k(2:end));
  stretch = to > from + 1 & middle(to) - middle(from) > 4 * (s(end) - s(1)) / numel (middle);
  turned = a(from) .* a(to) < 0 & ! stretch;
  [from, to] = deal (from(turned), to(turned));
  x = middle(from) + a(from) ./ (a(from) - a(to)) .* (middle(to) - middle(from));
endfunction

function x = above (x, size)
  x(abs (x) <= size) = 0;
endfunction

function quadratic (who, m, names, s)
  error (["%s: %s: %s at s = %.6g is not linear in the acceleration and quadratic in the " ...
          "speed: expected friction that is viscous or dry, drives that are linear"], who, ...
         m.name, strjoin (names, ", "), s);
endfunction

## Efforts of the planned coordinates, then the inputs (NaN where FEW), in the columns of Q, DQ,
## DDQ; the coordinates there.  GUESS of closed chains: a column each, or one for the first.
function [f, guess] = quantities (who, m, planned, few, guess, q, dq, ddq)
  if (m.sizes.nlam > 0)
    [f, guess] = of_loops (who, m, planned, few, guess, q, dq, ddq);
    return;
  endif
  jets = zeros (m.sizes.nu, columns (q), m.order + 1);
  jets(planned,:,1) = q;
  jets(planned,:,2) = dq;
  jets(planned,:,3) = ddq;
  guess = jets(:,:,1);
  f = [m.module("many", "inv", m.cst, 0, guess, jets(:,:,2), jets(:,:,3)); ...
       commands(m, few, permute (jets, [1, 3, 2]))];
endfunction

function [f, found] = of_loops (who, m, planned, few, guess, q, dq, ddq)
  last = guess(:,1);
  for k = 1:columns (q)
    if (columns (guess) > 1)
      last = guess(:,k);
    endif
    jet = gs.plan.whole_motion (who, m, [q(:,k), dq(:,k), ddq(:,k)], planned, 0, last);
    last = found(:,k) = jet(:,1);
    f(:,k) = [m.inl(0, jet(:,1), jet(:,2), jet(:,3)); commands(m, few, jet)];
  endfor
endfunction

## the inputs for the motions JETS, a page each
function v = commands (m, few, jets)
  v = NaN (m.sizes.nv, size (jets, 3));
  call = "cmd";
  if (any (strcmp (m.subroutines, "cmq")))
    [call, jets] = deal ("cmq", jets(:,1:3,:));
  endif
  for k = 1:size (jets, 3) * ! few
    v(:,k) = m.(call) (0, jets(:,:,k));
  endfor
endfunction

function [q, dq, ddq] = path_at (path, s)
  f = gsmbp_evaluate (path, s, 2);
  [q, dq, ddq] = deal (f(:,:,1), f(:,:,2), f(:,:,3));
endfunction

function top = top_of (path, s, speed)
  top = Inf (1, numel (s));
  for side = [-1, 1]
    dq = gsmbp_evaluate (path, s, 1, side)(:,:,2);
    fast = max (max (dq ./ speed(:,2), dq ./ speed(:,1)), [], 1);
    fast(! (fast > 0)) = 0;
    top = min (top, 1 ./ fast .^ 2);
  endfor
endfunction
