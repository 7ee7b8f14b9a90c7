## R = gsmbp__rotated (r)
## The rotation matrix of a rotation vector R: its direction the axis, its length the angle [rad].

function R = gsmbp__rotated (r)
  angle = norm (r);
  K = gsmbp__cross (r);
  R = eye (3) + sinc (angle / pi) * K + sinc (angle / (2 * pi))^2 / 2 * K^2;
endfunction
