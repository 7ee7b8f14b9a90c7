## yes = ne_redundant (K): true if the constraints of k = ne_rows (...) depend on each other.

function yes = ne_redundant (k)
  H = ne_jacobian (k);
  yes = rank (H, 1e-9 * max (1, norm (H))) < rows (H);
end
