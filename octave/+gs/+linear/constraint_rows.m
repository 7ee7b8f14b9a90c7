## [P, H, K] = gs.linear.constraint_rows (m, t, x)
## The constraints of the model M at the state X, those of Euler parameters first, differentiated by
## coordinates (P), by speeds (H, of loops alone) and, with their rates, by states (K).

function [P, H, K] = constraint_rows (m, t, x)
  d = m.sizes;
  sets = m.orientation;
  P = zeros (rows (sets), d.nq);
  for k = 1:rows (sets)
    P(k,sets(k,:)) = x(sets(k,:));
  endfor
  H = zeros (0, d.nu);
  K = [P, zeros(rows (P), d.nx - d.nq)];
  if (d.nlam > 0)
    [DP, DV] = m.tan (t, x);
    [~, ~, H] = m.con (t, x(1:d.nq), x(d.nq + (1:d.nu)));
    P = [P; DP];
    K = [K; DP, zeros(d.nlam, d.nx - d.nq); DV, H, zeros(d.nlam, d.nx - d.nq - d.nu)];
  endif
endfunction
