## [tau, lam] = ne_inverse (M, Q, U, UD, ACTUATED): efforts that the motion needs, by Newton-Euler
## in maximal coordinates (see ne_rows). ACTUATED lists the speeds that carry an effort (default
## all; with loops as many as are independent). LAM are the loop forces on body B. The motion must
## close the loops. Dampers and springs of the case are passive efforts of every joint.

function [tau, lam] = ne_inverse (m, q, u, ud, actuated)
  k = ne_rows (m, q, u);
  nu = columns (k.E);
  if (nargin < 5)
    actuated = 1:nu;
  end
  a = k.J \ (k.gamma + k.E * ud(:));
  ## tau + passive = E' X with J' X + L' lam = mass a - force
  through = k.J' \ [k.mass * a - k.force, k.L'];
  all = k.E' * through;
  effort = eye (nu)(:, actuated);
  x = [effort, all(:, 2:end)] \ (all(:, 1) - k.passive);
  tau = zeros (nu, 1);
  tau(actuated) = x(1:numel (actuated));
  lam = x(numel (actuated)+1:end);
end
