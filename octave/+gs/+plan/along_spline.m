## f = gs.plan.along_spline (path, s, f)
## Where a frame is on the spline PATH whose way, speed and acceleration along it are the rows of S:
## fields p, v, a, R, omega, alpha of F.

function f = along_spline (path, s, f)
  x = abscissae (path, s(1,:));
  c = gsmbp_evaluate (path.curve, x, 2);
  [f.p, d, dd] = deal (c(:,:,1), c(:,:,2), c(:,:,3));
  long = sqrt (sumsq (d));
  xd = s(2,:) ./ long;
  xdd = (s(3,:) - dot (d, dd, 1) ./ long .* xd .^ 2) ./ long;
  f.v = d .* xd;
  f.a = dd .* xd .^ 2 + d .* xdd;
  [f.omega, f.alpha] = deal (zeros (3, columns (s)));
  f.R = zeros (3, 3, columns (s));
  for k = 1:columns (s)
    [f.R(:,:,k), f.omega(:,k), f.alpha(:,k)] = turned (path.turns, x(k), xd(k), xdd(k));
  endfor
endfunction

## the abscissae of the curve where its lengths are s
function x = abscissae (path, s)
  arc = path.arc;
  i = lookup (arc(2,:), s, "lr");
  [low, high] = deal (arc(1,i), arc(1,i+1));
  x = low + (high - low) .* (s - arc(2,i)) ./ (arc(2,i+1) - arc(2,i));
  x = min (max (x, low), high);
  left = 1:numel (s);   # those that are not found yet
  for iteration = 1:8
    [a, b, y] = deal (low(left), high(left), x(left));
    miss = arc(2,i(left)) + gs.plan.arc_length (path.curve, a, y) - s(left);
    y -= miss ./ sqrt (sumsq (gsmbp_evaluate (path.curve, y, 1)(:,:,2)));
    x(left) = min (max (y, a), b);
    left = left(abs (miss) > 4 * eps * arc(2,end));
    if (isempty (left))
      return;
    endif
  endfor
endfunction

function [R, omega, alpha] = turned (t, x, xd, xdd)
  i = min (max (1, sum (x >= t.knots)), numel (t.knots) - 1);
  y = x - t.knots(i);
  c = t.coefs(:,:,i);
  r = c * [y; y^2; y^3];
  rx = c * [1; 2 * y; 3 * y^2];
  [A, wd] = gs.plan.turning_rate (r, rx * xd, c * [0; 2; 6 * y] * xd^2 + rx * xdd);
  R = t.R(:,:,i) * gs.plan.rotation_matrix (r);
  omega = R * (A * (rx * xd));
  alpha = R * wd;
endfunction
