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
  B = difference (@(h) momentum (tree, q + h * qd, qd));
  for k = 1:n
    B(k) -= difference (@(h) lagrangian (tree, q + h * E(:, k), qd));
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

## derivative of f at 0
function d = difference (f)
  h = 0.004;
  c = [4/5, -1/5, 4/105, -1/280];
  d = 0;
  for k = 1:4
    d += c(k) * (f (k * h) - f (-k * h)) / h;
  end
end
