## [motion, laws] = scara_cycle (Q): by the corners Q of the gate (of scara_gate) from pick to
## place, at rest in each, by double S, the joints together; a rest of 0.1 s at the place.

function [motion, laws] = scara_cycle (q)
  [motion, laws] = gsmbp_plan ("double_s", q, "speed", [4, 6, 0.9, 12], "acceleration", ...
                               [30, 60, 8, 100], "jerk", [600, 1200, 200, 2000]);
  motion = scara_held (motion, 0.1);
endfunction
