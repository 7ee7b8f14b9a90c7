## [P, angle, tau, v] = scara_hand (P, Q, U, UD): by hand, for parameters P (a struct, m.par):
## place of the tool [m] and the angle of its x axis; efforts with rotors and bearings of the motors
## [N*m, N]; voltages as if the motors had no inductance [V]. Q, U, UD: 4 x k.

function [P, angle, tau, v] = scara_hand (p, q, u, ud)
  both = q(1,:) + q(2,:);
  P = [p.l1 * cos(q(1,:)) + p.l2 * cos(both); p.l1 * sin(q(1,:)) + p.l2 * sin(both)
       p.h - q(3,:) - p.d];
  angle = both - q(4,:);
  if (nargin < 3)
    return;
  endif
  carried = 1.2 + p.mh + p.mp;
  a = 0.065 + 6 * 0.14^2 + (4 + carried) * p.l1^2;
  b = (4 * 0.1 + carried * p.l2) * p.l1;
  c = 0.032 + 4 * 0.1^2 + carried * p.l2^2 + 0.0004;
  hand = (0.0005 + p.mp / 600) * (ud(1,:) + ud(2,:) - ud(4,:));
  [cq, sq] = deal (cos (q(2,:)), sin (q(2,:)));
  sums = ud(1,:) + ud(2,:);
  tau = [a * ud(1,:) + c * sums + b * cq .* (2 * ud(1,:) + ud(2,:)) ...
           - b * sq .* u(2,:) .* (2 * u(1,:) + u(2,:)) + hand
         c * sums + b * cq .* ud(1,:) + b * sq .* u(1,:) .^ 2 + hand
         carried * (ud(3,:) - p.g)
         -hand];
  [n, R, K] = deal ([50; 40; 2*pi/0.016; 20], [0.9; 0.9; 1.6; 1.6], [0.07; 0.07; 0.06; 0.06]);
  [J, B] = deal ([4; 4; 1.5; 1.5] * 1e-5, [5; 5; 2; 2] * 1e-5);
  tau += [0.4; 0.2; 20; 0.02] .* u + n .^ 2 .* (J .* ud + B .* u);
  v = R .* tau ./ (n .* K) + K .* n .* u;
endfunction
