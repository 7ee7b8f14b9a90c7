## [q, sd, sdd, n, top] = stewart_legs (PAR, POSE, RATE, ACC): closed inverse kinematics: angles a,
## b and stroke s of each leg (3 x 6), speed and acceleration of the strokes (6 x 1), directions of
## the legs (3 x 6), their points on the platform (3 x 6, platform axes).

function [q, sd, sdd, n, top] = stewart_legs (p, pose, rate, acc)
  turn = @(k) [cosd(120*k), -sind(120*k), 0; sind(120*k), cosd(120*k), 0; 0, 0, 1];
  base = [turn(0) * [p.rb p.rb; p.wb -p.wb; 0 0], turn(1) * [p.rb p.rb; p.wb -p.wb; 0 0], ...
          turn(2) * [p.rb p.rb; p.wb -p.wb; 0 0]];
  top = [turn(2) * [-p.rp; p.wp; 0], turn(1) * [-p.rp; -p.wp; 0], turn(0) * [-p.rp; p.wp; 0], ...
         turn(2) * [-p.rp; -p.wp; 0], turn(1) * [-p.rp; p.wp; 0], turn(0) * [-p.rp; -p.wp; 0]];
  [~, ~, ~, R, Rd, Rdd] = stewart_turning (pose, rate, acc);
  D = pose(1:3) + R * top - base;
  V = rate(1:3) + Rd * top;
  A = acc(1:3) + Rdd * top;
  L = sqrt (sum (D .^ 2));
  n = D ./ L;
  q = [atan2(-n(2,:), n(3,:)); asin(n(1,:)); L - p.lc - p.lr];
  sd = sum (n .* V)';
  sdd = (sum (n .* A) + (sum (V .^ 2) - sd' .^ 2) ./ L)';
endfunction
