## T = pose_turn (AXIS, ANGLE): the placement (4 x 4) of a frame turned by ANGLE about AXIS, one of
## 1, 2, 3 or a unit vector, through the origin.

function T = pose_turn (axis, angle)
  e = axis(:);
  if (isscalar (axis))
    e = double ((1:3)' == axis);
  end
  K = [0, -e(3), e(2); e(3), 0, -e(1); -e(2), e(1), 0];
  T = eye (4);
  T(1:3, 1:3) += sin (angle) * K + (1 - cos (angle)) * K * K;
end
