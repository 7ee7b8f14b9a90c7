## s = gs.plan.arc_length (curve, from, to)
## The lengths of a curve (a piecewise polynomial) between close abscissae of one piece, FROM and TO
## rows: Gauss and Legendre, eight points.

function s = arc_length (curve, from, to)
  persistent x w
  if (isempty (x))
    n = 1:7;
    b = n ./ sqrt (4 * n .^ 2 - 1);
    [V, D] = eig (diag (b, 1) + diag (b, -1));   # Golub and Welsch
    x = diag (D);
    w = 2 * V(1,:) .^ 2;
  endif
  at = (from + to) / 2 + x * (to - from) / 2;
  speed = sqrt (sumsq (gsmbp_evaluate (curve, at, 1)(:,:,2)));
  s = (to - from) / 2 .* (w * reshape (speed, size (at)));
endfunction
