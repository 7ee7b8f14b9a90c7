## [ud, lam, wrench, ud_loop] = ne_forward (M, Q, U, TAU, T): joint accelerations and loop forces
## (on body B) under the joint efforts TAU, dampers and springs of the case included. One linear
## system of all body accelerations and all constraint forces; no mass matrix of joint coordinates
## is formed. Rows that depend on others are allowed: the forces are then those of least norm.
## wrench: 6 rows, a column a joint (tree joints, then loop joints): force and moment about the
## child's joint point that the parent exerts on the child, world axes. ud_loop: accelerations of
## the loop joints' own coordinates.

function [ud, lam, wrench, ud_loop] = ne_forward (m, q, u, tau, t)
  if (nargin < 5)
    t = 0;
  end
  n = 6 * numel (m.body);
  k = ne_rows (m, q, u, t);
  [nu, nl, nc] = deal (columns (k.E), rows (k.L), rows (k.U));
  A = [k.mass, -k.J', zeros(n, nu), -k.L', zeros(n, nc);
       k.J, zeros(n), -k.E, zeros(n, nl + nc);
       zeros(nu, n), k.E', zeros(nu, nu + nl), -k.U';
       k.L, zeros(nl, n + nu + nl + nc);
       zeros(nc, 2 * n), k.U, zeros(nc, nl + nc)];
  b = [k.force; k.gamma; tau(:) + k.passive; k.gamma_loop; k.gamma_user];
  if (nl + nc && ne_redundant (k))
    x = pinv (A) * b;
  else
    x = A \ b;
    x += A \ (b - A * x);
  end
  ud = x(2*n+1:2*n+nu);
  lam = x(2*n+nu+1:2*n+nu+nl);
  wrench = zeros (6, 0);
  for j = 1:n/6
    wrench(:, j) = k.wrench{j} * x(n + 6 * j - (5:-1:0));
  end
  first = 0;
  for l = n/6+1:numel (k.wrench)
    wrench(:, l) = k.wrench{l} * lam(first + (1:columns (k.wrench{l})));
    first += columns (k.wrench{l});
  end
  if (nargout > 3)
    [~, ~, ud_loop] = ne_own (m, k, x(1:n));
  end
end
