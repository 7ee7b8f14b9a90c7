## [tau, lam] = ne_inverse (M, Q, U, UD, ACTUATED): efforts that the motion needs, by Newton-Euler in maximal coordinates (see ne_rows).
## ACTUATED lists the joints that carry an effort (default all; with loops as many as are independent). LAM are the loop forces on body B.
## The motion must close the loops. Damping of the case is a passive effort of every joint.

function [tau, lam] = ne_inverse (m, q, u, ud, actuated)
  n = numel (m.body);
  if (nargin < 5)
    actuated = 1:n;
  end
  k = ne_rows (m, q, u);
  passive = -[m.joint.damping]' .* u(:);
  a = k.J \ (k.gamma + k.E * ud(:));
  carried = setdiff (1:6 * n, k.free(setdiff (1:n, actuated)));
  rows = [k.J(carried, :); k.L];
  efforts = rows' \ (k.mass * a - k.force - k.J(k.free, :)' * passive);
  all = zeros (6 * n, 1);
  all(carried) = efforts(1:numel (carried));
  tau = all(k.free);
  lam = efforts(numel (carried) + 1:end);
end
