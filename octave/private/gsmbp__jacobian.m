## [A, B, C, D] = gsmbp__jacobian (who, m, t, x, v)
## The Jacobians of the subroutine JAC of the model M; an error of WHO where a derivative of the
## rates is not finite.

function [A, B, C, D] = gsmbp__jacobian (who, m, t, x, v)
  [A, B, C, D] = m.jac (t, x, v);
  gsmbp__need_derivatives ([who, ": ", m.name], [A, B], strcat ({"rate of "}, m.states(:)), ...
                           [m.states(:); m.inputs(:)]);
endfunction
