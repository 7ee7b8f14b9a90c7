## rows = gsmbp__path_rows (who, m, path, planned, limits, s, guess)
## The limits along a path between the places S: least <= a*s'' + b*s'^2 + d*s' + c <= largest
## in the middle of each interval (a, b, c, d: limited quantities x intervals), names of the
## quantities,
## and the largest s'^2 that the limits of speed allow at each place.

function rows = gsmbp__path_rows (who, m, path, planned, limits, s, guess)
  middle = (s(1:end-1) + s(2:end)) / 2;
  [q, dq, ddq] = path_at (path, middle);
  closed = m.sizes.nlam > 0 && numel (planned) < m.sizes.nu;
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
  for k = 1:numel (middle)
    at = @(rate, second) quantities (who, m, planned, closed, guess, few, ...
                                     [q(:,k), dq(:,k) * rate, ...
                                         dq(:,k) * second + ddq(:,k) * rate^2]);
    [f1, guess] = at (1, 0);   # at rate 1, without acceleration
    f = [f1, at(2, 0), at(3, 0)](used,:);
    fa = at (1, 1)(used);
    rounding = 32 * eps * max (abs ([f, fa]), [], 2);   # where a coordinate stands still
    rows.a(:,k) = above (fa - f(:,1), rounding);
    rows.b(:,k) = above ((f(:,3) - 2 * f(:,2) + f(:,1)) / 2, rounding);
    rows.d(:,k) = above (f(:,2) - f(:,1) - 3 * rows.b(:,k), rounding);
    rows.c(:,k) = f(:,1) - rows.d(:,k) - rows.b(:,k);
    if (mod (k, 16) == 1)
      there = at (1.5, -2)(used);
      said = -2 * rows.a(:,k) + 2.25 * rows.b(:,k) + 1.5 * rows.d(:,k) + rows.c(:,k);
      off = abs (there - said) > 1e-6 * (abs (f1(used)) + abs (there) + abs (rows.a(:,k)));
      quadratic (who, m, rows.names(off), middle(k));
    endif
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
  if (! isempty (names))
    error (["%s: %s: %s at s = %.6g is not linear in the acceleration and quadratic in the " ...
            "speed: expected friction that is viscous or dry, drives that are linear"], ...
           who, m.name, strjoin (names, ", "), s);
  endif
endfunction

## efforts of the planned coordinates, then the inputs (left out where FEW)
function [f, guess] = quantities (who, m, planned, closed, guess, few, jet)
  one = zeros (m.sizes.nu, m.order + 1);
  one(planned,1:3) = jet;
  if (m.sizes.nlam > 0)
    one = gsmbp__whole_motion (who, m, jet, planned, closed, 0, guess);
  endif
  guess = one(:,1);
  if (m.sizes.nlam > 0)
    f = m.inl (0, one(:,1), one(:,2), one(:,3));
  else
    f = m.inv (0, one(:,1), one(:,2), one(:,3));
  endif
  v = NaN (m.sizes.nv, 1);
  if (! few && any (strcmp (m.subroutines, "cmq")))
    v = m.cmq (0, one(:,1:3));
  elseif (! few)
    v = m.cmd (0, one);
  endif
  f = [f(:); v(:)];
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
