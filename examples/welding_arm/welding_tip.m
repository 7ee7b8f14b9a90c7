## [P, R] = welding_tip (Q): place [m] and axes of the end of the wire at the joint angles Q
## (6 x k), by the transformations of welding_arm.urdf one after the other, not by the scene.

function [P, R] = welding_tip (q)
  offsets = [0 0 0.15; 0.06 0 0.25; 0 0 0.45; 0.15 0 0.05; 0.3 0 0; 0.085 0 0]';
  axes = [3 2 2 1 2 1];
  [P, R] = deal (zeros (3, columns (q)), zeros (3, 3, columns (q)));
  for k = 1:columns (q)
    T = eye (4);
    for j = 1:6
      T *= [turn(axes(j), q(j,k)), offsets(:,j); 0 0 0 1];
    endfor
    T *= [turn(2, 3*pi/4), [0.31; 0; -0.09]; 0 0 0 1];
    [P(:,k), R(:,:,k)] = deal (T(1:3,4), T(1:3,1:3));
  endfor
endfunction

function R = turn (axis, angle)
  [c, s] = deal (cos (angle), sin (angle));
  R = {[1 0 0; 0 c -s; 0 s c], [c 0 s; 0 1 0; -s 0 c], [c -s 0; s c 0; 0 0 1]}{axis};
endfunction
