## [s, V, W, reduced] = gs.linear.state_poles (who, m, t, x, v)
## Poles of the linear model in independent states about the state X of the model M, a struct:
## poles, by rising size, frequency and damping of those with positive imaginary part.  V, W: right
## and left eigenvectors of the matrix; REDUCED (m, x, v): that matrix elsewhere.

function [s, V, W, reduced] = state_poles (who, m, t, x, v)
  [~, free] = gs.linear.loop_tangent (who, m, t, x, []);
  reduced = @(m, x, v) m.jac (t, x, v)(free,:) ...
                       * gs.linear.loop_tangent (who, m, t, x, free);
  [V, e, W] = eig (reduced (m, x, v), "vector");
  [~, order] = sort (abs (e));
  [V, e, W] = deal (V(:,order), e(order), W(:,order));
  up = e(imag (e) > 0);
  s = struct ("poles", e, "frequency", abs (up), "damping", -real (up) ./ abs (up));
endfunction
