## [w, beside] = gs.linear.rest_worst (p, z)
## How far Z is from a solution of the problem P.

function [w, beside] = rest_worst (p, z)
  [f, J] = gs.linear.rest_equations (p, z);
  rounding = 1e3 * eps * (abs (J) * max (abs (z), p.size));
  beside = abs (f) ./ max (p.tolerance * p.usual, rounding);
  beside(! isfinite (beside)) = Inf;
  w = max ([beside; 0]);
endfunction
