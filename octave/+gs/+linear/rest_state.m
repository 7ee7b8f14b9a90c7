## [x, v] = gs.linear.rest_state (p, z)
## State and inputs of the problem P that belong to its unknowns Z.

function [x, v] = rest_state (p, z)
  [x, v] = deal (p.x, p.v);
  n = numel (p.own);
  x(p.own) = z(1:n);
  v(p.inputs) = z(n + 1:end);
endfunction
