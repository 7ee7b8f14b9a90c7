## [L, S] = gs.collocation.lagrange_basis (c, x)
## The polynomials that are 1 at one of the places C and 0 at the others (a row each), at the places
## X, and their integrals from 0.

function [L, S] = lagrange_basis (c, x)
  n = numel (c);
  L = S = zeros (n, numel (x));
  for k = 1:n
    p = poly (c([1:k-1, k+1:n]));
    p /= polyval (p, c(k));
    L(k,:) = polyval (p, x);
    S(k,:) = polyval (polyint (p), x);
  endfor
endfunction
