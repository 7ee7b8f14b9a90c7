## [R, size] = gs.report.inertia_box (mass, I)
## The box of the same mass [kg] and inertia I [kg m^2]: its axes R and sizes [m], 0 without mass.

function [R, size] = inertia_box (mass, I)
  [R, J] = eig ((I + I') / 2);
  if (det (R) < 0)
    R(:,1) *= -1;
  endif
  J = max (diag (J), 0);
  size = zeros (3, 1);
  if (mass > 0)
    size = sqrt (max (0, 6 / mass * (sum (J) - 2 * J)));
  endif
endfunction
