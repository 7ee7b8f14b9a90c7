## [path, corners] = scara_gate (M, BRANCH): the way of the tool from pick to place, its coordinates
## by the inverse kinematics on that BRANCH (1 or 2) as a piecewise polynomial of the way s [m]: up
## by 80 mm, across, down, the corners rounded so that the curvature does not jump; the hand turns
## the part by 90 degrees on the way. corners: the coordinates at pick, above it, above the place,
## at the place.

function [path, corners] = scara_gate (m, branch)
  pick = [0.36; -0.22; 0.08; 0];
  place = [0.05; 0.44; 0.08; pi/2];
  up = [0; 0; 0.08; 0];
  corners = reached (m, [pick, pick + up, place + up, place], branch);
  across = gsmbp_plan ("quintic", [pick, place], [0.14, 0.86]);
  lifted = gsmbp_plan ("quintic", [0, 1, 1, 0], [0, 0.3, 0.7, 1]);
  arch = @(k) gsmbp_evaluate (across, k) + up * gsmbp_evaluate (lifted, k);
  ## places at equal distances along the arch
  k = linspace (0, 1, 20001);
  s = [0, cumsum(norm (diff (arch (k)(1:3,:), 1, 2), "columns"))];
  even = linspace (0, s(end), 81);
  path = gsmbp_plan ("table", even, reached (m, arch (interp1 (s, k, even)), branch)', 3);
endfunction

## coordinates of places with the tool upright and turned: columns x, y, z, angle
function q = reached (m, x, branch)
  for k = 1:columns (x)
    [c, s] = deal (cos (x(4,k)), sin (x(4,k)));
    R(:,:,k) = [c, s, 0; s, -c, 0; 0, 0, -1];
  endfor
  q = gsmbp_reach (m, "tool", x(1:3,:), R, "branch", branch, "start", [0.1; 0; 0.2; 0]);
endfunction
