## [motion, laws] = scara_cycle (Q): by the corners Q of the gate (of scara_gate) from pick to
## place, at rest in each, by double S, the joints together; a rest of 0.1 s at the place.

function [motion, laws] = scara_cycle (q)
  [motion, laws] = gsmbp_plan ("double_s", q, "speed", [4, 6, 0.9, 12], "acceleration", ...
                               [30, 60, 8, 100], "jerk", [600, 1200, 200, 2000]);
  coefs = reshape (motion.coefs, 4, motion.pieces, motion.order);
  rest = zeros (4, 1, motion.order);
  rest(:,1,end) = q(:,end);
  motion = mkpp ([motion.breaks, motion.breaks(end) + 0.1], cat (2, coefs, rest), 4);
endfunction
