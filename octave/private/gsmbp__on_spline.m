## f = gsmbp__on_spline (path, s, f)
## Where a frame is on the spline PATH whose way, speed and acceleration along it are the rows of S:
## fields p, v, a, R, omega, alpha of F.

function f = gsmbp__on_spline (path, s, f)
  n = columns (s);
  [f.p, f.v, f.a, f.omega, f.alpha] = deal (zeros (3, n));
  f.R = zeros (3, 3, n);
  for k = 1:n
    x = abscissa (path, s(1,k));
    c = reshape (gsmbp_evaluate (path.curve, x, 2), 3, 3);
    long = norm (c(:,2));
    xd = s(2,k) / long;
    xdd = (s(3,k) - c(:,2)' * c(:,3) / long * xd^2) / long;
    f.p(:,k) = c(:,1);
    f.v(:,k) = c(:,2) * xd;
    f.a(:,k) = c(:,3) * xd^2 + c(:,2) * xdd;
    [f.R(:,:,k), f.omega(:,k), f.alpha(:,k)] = turned (path.turns, x, xd, xdd);
  endfor
endfunction

## the abscissa of the curve where its length is s
function x = abscissa (path, s)
  arc = path.arc;
  i = min (max (1, sum (s >= arc(2,:))), columns (arc) - 1);
  x = arc(1,i) + (arc(1,i+1) - arc(1,i)) * (s - arc(2,i)) / (arc(2,i+1) - arc(2,i));
  x = min (max (x, arc(1,i)), arc(1,i+1));
  for iteration = 1:8
    miss = arc(2,i) + gsmbp__way (path.curve, arc(1,i), x) - s;
    x -= miss / norm (gsmbp_evaluate (path.curve, x, 1)(:,:,2));
    x = min (max (x, arc(1,i)), arc(1,i+1));
    if (abs (miss) <= 4 * eps * arc(2,end))
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
  [A, wd] = gsmbp__turning_rate (r, rx * xd, c * [0; 2; 6 * y] * xd^2 + rx * xdd);
  angle = norm (r);
  K = [0, -r(3), r(2); r(3), 0, -r(1); -r(2), r(1), 0];
  R = t.R(:,:,i) * (eye (3) + sinc (angle / pi) * K + sinc (angle / (2 * pi))^2 / 2 * K^2);
  omega = R * (A * (rx * xd));
  alpha = R * wd;
endfunction
