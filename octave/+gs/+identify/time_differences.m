## [d, dd] = gs.identify.time_differences (x, h)
## First and second derivatives of the columns of X, sampled every H seconds, by central differences
## of order 6; the first and the last three rows are NaN.

function [d, dd] = time_differences (x, h)
  n = rows (x);
  d = dd = NaN (size (x));
  at = 4:n-3;
  d(at,:) = dd(at,:) = 0;
  dd(at,:) = -490 * x(at,:);
  first = [45, -9, 1];
  second = [270, -27, 2];
  for k = 1:3
    d(at,:) += first(k) * (x(at+k,:) - x(at-k,:));
    dd(at,:) += second(k) * (x(at+k,:) + x(at-k,:));
  endfor
  d /= 60 * h;
  dd /= 180 * h ^ 2;
endfunction
