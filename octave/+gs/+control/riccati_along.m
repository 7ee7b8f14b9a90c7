## P = gs.control.riccati_along (model, times, steps, P)
## Riccati's equation -P' = A'P + P A - P B R^-1 B' P + Q backwards from P at the last of the TIMES:
## a page of P for each of them.  MODEL (t) gives {A, B R^-1 B', Q} at a list of times; STEPS
## between two of them by Magnus' method of order 4 (two points of Gauss) on the Hamiltonian matrix.

function all_ = riccati_along (model, times, steps, P)
  n = rows (P);
  nt = numel (times);
  all_ = zeros (n, n, nt);
  all_(:,:,nt) = P;
  gauss = [-1, 1] / sqrt (12);
  for i = nt - 1:-1:1
    h = (times(i+1) - times(i)) / steps;
    middle = times(i) + h * ((steps:-1:1) - 0.5);
    parts = model ((middle + h * gauss')(:)');
    for k = 1:steps
      H1 = hamiltonian (parts{2*k-1,:});
      H2 = hamiltonian (parts{2*k,:});
      E = expm (-h / 2 * (H1 + H2) + sqrt (3) / 12 * h ^ 2 * (H1 * H2 - H2 * H1));
      X = E(1:n,1:n) + E(1:n,n+1:end) * P;
      Y = E(n+1:end,1:n) + E(n+1:end,n+1:end) * P;
      P = Y / X;
      P = (P + P') / 2;
    endfor
    all_(:,:,i) = P;
  endfor
endfunction

function H = hamiltonian (A, S, Q)
  H = [A, -S; -Q, -A'];
endfunction
