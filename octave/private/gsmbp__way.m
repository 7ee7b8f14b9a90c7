## s = gsmbp__way (curve, from, to)
## The length of a curve (a piecewise polynomial) between two close abscissae of one piece: Gauss
## and Legendre, eight points.

function s = gsmbp__way (curve, from, to)
  persistent x w
  if (isempty (x))
    n = 1:7;
    b = n ./ sqrt (4 * n .^ 2 - 1);
    [V, D] = eig (diag (b, 1) + diag (b, -1));   # Golub and Welsch
    x = diag (D)';
    w = 2 * V(1,:) .^ 2;
  endif
  at = (from + to) / 2 + (to - from) / 2 * x;
  speed = gsmbp_evaluate (curve, at, 1)(:,:,2);
  s = (to - from) / 2 * (sqrt (sumsq (speed)) * w');
endfunction
