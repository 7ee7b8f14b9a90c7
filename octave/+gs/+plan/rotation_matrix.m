## R = gs.plan.rotation_matrix (r)
## The rotation matrix of a rotation vector R: its direction the axis, its length the angle [rad].

function R = rotation_matrix (r)
  angle = norm (r);
  K = gs.plan.cross_matrix (r);
  R = eye (3) + sinc (angle / pi) * K + sinc (angle / (2 * pi))^2 / 2 * K^2;
endfunction
