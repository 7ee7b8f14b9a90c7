## [most, errors] = gs.collocation.mesh_errors (m, s)
## The estimated error of the states of a solution S of gs.collocation.solve_mesh in each interval:
## the integral of |rate of the polynomial - rate of the machine there| by Gauss's formula of 4
## points, relative to the largest value of the state or 1.  Source: Betts (2010), section 4.7.

function [most, errors] = mesh_errors (m, s)
  c = s.c;
  at = [-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526];
  weight = [0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538] / 2;
  at = (1 + at) / 2;
  [L, S] = gs.collocation.lagrange_basis (c.mesh.rule.c, at);
  f = gs.collocation.node_rates (c, s.F, s.ud);
  m = gs.collocation.model_with (m, c, s.parameters);
  n = columns (c.left);
  errors = zeros (c.d.nx, n);
  T = s.T(c.mesh.breaks(1,:));
  for k = 1:n
    q = c.stage(:,k);
    h = c.h(k) * T(k);
    x = s.x(:,c.left(k)) + h * f(:,q) * S;
    v = s.v(:,q) * L;
    poly = f(:,q) * L;
    begin = s.times(c.left(k));
    for i = 1:numel (at)
      [xd, ~] = m.rhs (begin + h * at(i), x(:,i), v(:,i));
      errors(:,k) += h * weight(i) * abs (poly(:,i) - xd);
    endfor
  endfor
  errors(! isfinite (errors)) = Inf;
  errors = max (errors ./ (1 + max (abs (s.x), [], 2)), [], 1);
  most = max (errors);
endfunction
