## [f, J] = gs.linear.rest_equations (p, z, t = p.t)
## The equations of rest of the problem P at Z and their derivatives.

function [f, J] = rest_equations (p, z, t = p.t)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = gs.linear.rest_state (p, z);
  [xd, ~] = m.rhs (t, x, v);
  moves = ! isempty (p.steady);
  f = xd(p.rows);
  u = moves * x(d.nq + (1:d.nu));
  if (d.nlam > 0)
    [phi, phit, H] = m.con (t, x(1:d.nq), u);
    f = [f; phi; (H * u + phit)(1:moves * d.nlam)];
  endif
  [g, N] = norms (m, x);
  f = [f; g];
  if (nargout < 2)
    return;
  endif
  [A, B, ~, ~, ~] = m.jac (t, x, v);
  J = [A(p.rows, p.own), B(p.rows, p.inputs)];
  if (d.nlam > 0)
    [DP, DV] = m.tan (t, x);
    P = [DP, zeros(d.nlam, d.nx - d.nq); ...
         [DV, H, zeros(d.nlam, d.nx - d.nq - d.nu)](1:moves * d.nlam,:)];
    J = [J; P(:,p.own), zeros(rows (P), numel (p.inputs))];
  endif
  J = [J; N(:,p.own), zeros(rows (N), numel (p.inputs))];
endfunction

## squares of the Euler parameters less one, and their gradients
function [f, N] = norms (m, x)
  sets = m.orientation;
  f = zeros (rows (sets), 1);
  N = zeros (rows (sets), numel (x));
  for k = 1:rows (sets)
    f(k) = sum (x(sets(k,:)) .^ 2) - 1;
    N(k,sets(k,:)) = 2 * x(sets(k,:));
  endfor
endfunction
