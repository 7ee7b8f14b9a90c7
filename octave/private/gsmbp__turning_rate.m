## [A, wd] = gsmbp__turning_rate (r, rd, rdd)
## Of exp (r), r a rotation vector: its angular velocity in its own axes is A*rd; WD is the rate of
## that.

function [A, wd] = gsmbp__turning_rate (r, rd, rdd)
  ## series of (1 - cos x)/x^2 and (x - sin x)/x^3 and of their derivatives over x
  n = 0:19;
  x2 = r' * r;
  signs = (-1) .^ n;
  powers = x2 .^ n;
  f = sum (signs .* powers ./ factorial (2 * n + 2));
  g = sum (signs .* powers ./ factorial (2 * n + 3));
  K = [0, -r(3), r(2); r(3), 0, -r(1); -r(2), r(1), 0];
  A = eye (3) - f * K + g * K^2;
  if (nargout < 2)
    return;
  endif
  lower = [0, powers(1:end-1)];
  fd = sum (signs .* 2 .* n .* lower ./ factorial (2 * n + 2)) * (r' * rd);
  gd = sum (signs .* 2 .* n .* lower ./ factorial (2 * n + 3)) * (r' * rd);
  aside = K * rd;
  wd = A * rdd - fd * aside + gd * K * aside + g * cross (rd, aside);
endfunction
