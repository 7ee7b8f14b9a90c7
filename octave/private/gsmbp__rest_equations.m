## [f, J] = gsmbp__rest_equations (p, z, t = p.t)
## The equations of rest of the problem P at Z and their derivatives.

function [f, J] = gsmbp__rest_equations (p, z, t = p.t)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = gsmbp__rest_state (p, z);
  [xd, ~] = m.rhs (t, x, v);
  f = xd(d.nq + 1:end);
  if (d.nlam > 0)
    f = [f; m.con(t, x(1:d.nq), zeros (d.nu, 1))];
  endif
  [g, N] = norms (m, x);
  f = [f; g];
  if (nargout < 2)
    return;
  endif
  [A, B, ~, ~, ~] = m.jac (t, x, v);
  J = [A(d.nq + 1:end, p.own), B(d.nq + 1:end, p.inputs)];
  if (d.nlam > 0)
    P = [m.tan(t, x), zeros(d.nlam, d.nx - d.nq)];
    J = [J; P(:,p.own), zeros(d.nlam, numel (p.inputs))];
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
