## [A, B, C] = gs.control.balanced_system (A, B, C)
## The system with states of like size.

function [A, B, C] = balanced_system (A, B, C)
  [S, X] = balance (A);
  [A, B, C] = deal (X, S \ B, C * S);
endfunction
