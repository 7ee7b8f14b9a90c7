## [A, B, C, D] = gs.linear.model_jacobian (who, m, t, x, v)
## The Jacobians of the subroutine JAC of the model M; an error of WHO where a derivative of the
## rates is not finite.

function [A, B, C, D] = model_jacobian (who, m, t, x, v)
  [A, B, C, D] = m.jac (t, x, v);
  gs.given.need_derivatives ([who, ": ", m.name], [A, B], strcat ({"rate of "}, m.states(:)), ...
                             [m.states(:); m.inputs(:)]);
endfunction
