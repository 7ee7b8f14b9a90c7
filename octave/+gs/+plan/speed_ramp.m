## [time, tj, ta] = gs.plan.speed_ramp (dv, A, J)
## The shortest change of speed by DV >= 0: jerk for tj, none for ta, jerk for tj again.

function [time, tj, ta] = speed_ramp (dv, A, J)
  if (isinf (J) || dv == 0)
    [tj, ta] = deal (0, dv / A);
  elseif (dv * J >= A^2)
    [tj, ta] = deal (A / J, max (0, dv / A - A / J));
  else
    [tj, ta] = deal (sqrt (dv / J), 0);
  endif
  time = 2 * tj + ta;
endfunction
