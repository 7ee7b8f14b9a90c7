## [M, B, T, V] = fx_terms (TREE, Q, QD): mass matrix and bias (dT/dQD)' - dT/dQ + dV/dQ at constant
## QD of the energies of fx_energy: M by polarization (T is quadratic in the rates), derivatives by
## differences of eighth order.

function [M, B, T, V] = fx_terms (tree, q, qd)
  n = numel (q);
  E = eye (n);
  M = zeros (n);
  for k = 1:n
    M(:, k) = momentum (tree, q, E(:, k));
  end
  [T, V] = fx_energy (tree, q, qd);
  B = ne_difference (@(h) momentum (tree, q + h * qd, qd), 0.004);
  for k = 1:n
    B(k) -= ne_difference (@(h) lagrangian (tree, q + h * E(:, k), qd), 0.004);
  end
end

## dT/dQD
function p = momentum (tree, q, qd)
  n = numel (q);
  E = eye (n);
  p = zeros (n, 1);
  for k = 1:n
    p(k) = (fx_energy (tree, q, qd + E(:, k)) - fx_energy (tree, q, qd - E(:, k))) / 2;
  end
end

function l = lagrangian (tree, q, qd)
  [T, V] = fx_energy (tree, q, qd);
  l = T - V;
end
