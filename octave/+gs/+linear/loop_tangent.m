## [T, k] = gs.linear.loop_tangent (who, m, t, x, names, held)
## The deviations that the constraints allow at the state X of the model M: T, whose columns change
## one independent state each, of the numbers k.  NAMES: "auto" (chosen by the Jacobian) or the
## numbers of the states that are wanted as independent ones.  HELD: numbers of coordinates and of
## their speeds, a row of two each, that do not deviate.

function [T, independent] = loop_tangent (who, m, t, x, names, held)
  d = m.sizes;
  [P, H, K] = gs.linear.constraint_rows (m, t, x);
  for pair = held'
    P(end+1,pair(1)) = 1;
    H(end+1,pair(2)) = 1;
    K(end+1,pair(1)) = 1;
    K(end+1,d.nq+pair(2)) = 1;
  endfor
  if (rows (K) == 0)
    [T, independent] = deal (eye (d.nx), 1:d.nx);
    return;
  endif
  if (strcmp (names, "auto"))
    q = others (P, 1:d.nq);
    if (d.nq == d.nu && numel (q) == numel (others (H, 1:d.nu)))
      u = q;
    else
      u = others (H, 1:d.nu);
    endif
  else
    [q, u] = chosen (m, names, H);
  endif
  independent = [q, d.nq + u, d.nq + d.nu + 1:d.nx];
  N = null (K, 1e-9);
  if (columns (N) != numel (independent) || rcond (N(independent,:)) < 1e-10)
    error (["%s: %s: %s do not determine the motion here: the constraints leave %d " ...
            "free states, %d are chosen"], who, m.name,
           strjoin (m.states(independent), ", "), columns (N), numel (independent));
  endif
  T = N / N(independent,:);
endfunction

## the columns that a rank-revealing factorization leaves over
function k = others (H, all_columns)
  k = all_columns;
  if (rows (H) > 0)
    [~, R, p] = qr (H, "vector");
    s = abs (diag (R(1:min (size (R)),1:min (size (R)))));
    k = sort (p(sum (s > 1e-9 * max ([s; eps])) + 1:end));
  endif
endfunction

## numbers of coordinates and speeds among the states K
function [q, u] = chosen (m, k, H)
  d = m.sizes;
  q = sort (k(k <= d.nq))(:)';
  u = sort (k(k > d.nq & k <= d.nq + d.nu) - d.nq)(:)';
  if (isempty (u) && d.nq == d.nu)
    u = q;
  elseif (isempty (u))
    u = others (H, 1:d.nu);
  endif
endfunction
