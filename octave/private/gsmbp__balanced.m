## [A, B, C] = gsmbp__balanced (A, B, C)
## The system with states of like size.

function [A, B, C] = gsmbp__balanced (A, B, C)
  [S, X] = balance (A);
  [A, B, C] = deal (X, S \ B, C * S);
endfunction
