## [e, w, wd, R, Rd, Rdd] = stewart_turning (POSE, RATE, ACC): of the platform at a pose [x; y; z;
## roll; pitch; yaw] with its rates and accelerations, R = Rx(roll) Ry(pitch) Rz(yaw): Euler
## parameters, angular velocity and acceleration in platform axes; R and its derivatives.

function [e, w, wd, R, Rd, Rdd] = stewart_turning (pose, rate, acc)
  c = cos (pose(4:6) / 2);
  s = sin (pose(4:6) / 2);
  times = @(a, b) [a(1)*b(1) - a(2:4)'*b(2:4); a(1)*b(2:4) + b(1)*a(2:4) + cross(a(2:4), b(2:4))];
  e = times (times ([c(1); s(1); 0; 0], [c(2); 0; s(2); 0]), [c(3); 0; 0; s(3)]);
  [t, u] = deal (pose(5), pose(6));
  [td, ud] = deal (rate(5), rate(6));
  B = [cos(t)*cos(u), sin(u), 0; -cos(t)*sin(u), cos(u), 0; sin(t), 0, 1];
  Bd = [-td*sin(t)*cos(u) - ud*cos(t)*sin(u), ud*cos(u), 0; td*sin(t)*sin(u) - ud*cos(t)*cos(u), ...
        -ud*sin(u), 0; td*cos(t), 0, 0];
  w = B * rate(4:6);
  wd = B * acc(4:6) + Bd * rate(4:6);
  R = eye (3) + 2 * e(1) * hat (e(2:4)) + 2 * hat (e(2:4)) ^ 2;
  Rd = R * hat (w);
  Rdd = R * (hat (wd) + hat (w) ^ 2);
endfunction

function H = hat (v)
  H = [0 -v(3) v(2); v(3) 0 -v(1); -v(2) v(1) 0];
endfunction
