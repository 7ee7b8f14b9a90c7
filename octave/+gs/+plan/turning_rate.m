## [A, wd, slope] = gs.plan.turning_rate (r, rd, rdd)
## Of exp (r), r a rotation vector: its angular velocity in its own axes is A*rd; WD is the rate of
## that, SLOPE the derivative of WD by RD.

function [A, wd, slope] = turning_rate (r, rd, rdd)
  [f, g, df, dg] = factors (norm (r));
  K = gs.plan.cross_matrix (r);
  A = eye (3) - f * K + g * K^2;
  if (nargout < 2)
    return;
  endif
  aside = K * rd;
  twice = K * aside;
  along = r' * rd;
  wd = A * rdd - df * along * aside + dg * along * twice + g * cross (rd, aside);
  if (nargout > 2)
    slope = (dg * twice - df * aside) * r' + along * (dg * K^2 - df * K) ...
            + g * (gs.plan.cross_matrix (rd) * K - gs.plan.cross_matrix (aside));
  endif
endfunction

## f = (1 - cos x)/x^2 and g = (x - sin x)/x^3 with their derivatives over x: by their series where
## the closed forms lose digits
function [f, g, df, dg] = factors (x)
  if (x < 1)
    n = 0:9;
    signs = (-1) .^ n;
    powers = x .^ (2 * n);
    lower = 2 * n .* [0, powers(1:end-1)];
    f = sum (signs .* powers ./ factorial (2 * n + 2));
    g = sum (signs .* powers ./ factorial (2 * n + 3));
    df = sum (signs .* lower ./ factorial (2 * n + 2));
    dg = sum (signs .* lower ./ factorial (2 * n + 3));
    return;
  endif
  f = (1 - cos (x)) / x^2;
  g = (x - sin (x)) / x^3;
  df = (sin (x) / x - 2 * f) / x^2;
  dg = (f - 3 * g) / x^2;
endfunction
