## signs = gs.proof.corner_signs (n)
## All corners of N tolerances: a row of +1 and -1 for each.

function signs = corner_signs (n)
  signs = 1 - 2 * (dec2bin (0:2^n - 1, max (n, 1)) - "0")(:,1:n);
endfunction
