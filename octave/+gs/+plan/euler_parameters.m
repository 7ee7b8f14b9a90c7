## [e, a] = gs.plan.euler_parameters (R)
## Of a rotation matrix (columns: the axes) the Euler parameters e, scalar first and not negative,
## and the angles a = [roll; pitch; yaw], R = Rz(yaw)*Ry(pitch)*Rx(roll).

function [e, a] = euler_parameters (R)
  ## of four times the products of two Euler parameters the column with the largest square: no digit
  ## is lost wherever the turn is
  v = [R(3,2)-R(2,3); R(1,3)-R(3,1); R(2,1)-R(1,2)];
  P = [1+trace(R), v'; v, R+R'+(1-trace(R))*eye(3)];
  [~, k] = max (diag (P));
  e = P(:,k) / norm (P(:,k));
  if (e(find (e, 1)) < 0)
    e = -e;
  endif
  a = [atan2(R(3,2), R(3,3)); atan2(-R(3,1), hypot (R(3,2), R(3,3))); atan2(R(2,1), R(1,1))];
endfunction
