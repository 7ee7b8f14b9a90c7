## [w, axis, angle] = gs.plan.rotation_vector (R)
## Axis and angle in [0, pi] of a rotation matrix, and their product; half a turn is about the axis
## whose largest component is positive.

function [w, axis, angle] = rotation_vector (R)
  v = [R(3,2) - R(2,3); R(1,3) - R(3,1); R(2,1) - R(1,2)] / 2;
  angle = atan2 (norm (v), (trace (R) - 1) / 2);
  axis = about (R, v, angle);
  w = angle * axis;
endfunction

## near half a turn the axis is that of the symmetric part
function axis = about (turn, w, angle)
  if (angle < 1e-14)
    axis = [0; 0; 1];
  elseif (angle < 3)
    axis = w / norm (w);
  else
    [~, k] = max (diag (turn));
    axis = (turn(:,k) + turn(k,:)') / 2 - cos (angle) * (1:3 == k)';
    axis /= norm (axis);
    if (norm (w) > 1e-14)
      axis *= 1 - 2 * (dot (axis, w) < 0);
    else
      [~, k] = max (abs (axis));
      axis *= sign (axis(k));
    endif
  endif
endfunction
