## v = ne_vector (R): the rotation vector (angle times unit axis) of a rotation.

function v = ne_vector (R)
  a = [R(3, 2) - R(2, 3); R(1, 3) - R(3, 1); R(2, 1) - R(1, 2)] / 2;
  s = norm (a);
  c = (trace (R) - 1) / 2;
  if (s > 1e-6)
    v = a * atan2 (s, c) / s;
  elseif (c > 0)
    v = a;
  else
    [axis, ~] = eigs_one (R);             # half a turn
    v = pi * axis;
  end
end

function [axis, value] = eigs_one (R)
  [V, D] = eig ((R + R') / 2);
  [value, k] = max (diag (D));
  axis = V(:, k);
end
