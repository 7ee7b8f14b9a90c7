## R = pose_rotation (E): the rotation matrix of Euler parameters (scalar first, of norm 1).

function R = pose_rotation (e)
  [s, v] = deal (e(1), e(2:4)(:));
  R = (s ^ 2 - v' * v) * eye (3) + 2 * v * v' + 2 * s ...
      * [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
end
