## E = pose_quaternion (R): Euler parameters of a rotation matrix, scalar first (of the two signs
## any).

function e = pose_quaternion (R)
  z = [R(3, 2) - R(2, 3); R(1, 3) - R(3, 1); R(2, 1) - R(1, 2)];
  [v, lambda] = eig ([trace(R), z'; z, R + R' - trace(R) * eye(3)]);
  [~, k] = max (diag (lambda));
  e = v(:, k);
end
