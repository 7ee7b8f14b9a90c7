## [q, u] = gs.linear.free_velocities (m, t, x, first)
## Which coordinates Q and speeds U of the model M move independently at the state X, chosen so
## that their accelerations depend on as few coordinates as can be: what may run steadily (of a
## disc that turns on a plane its spin, not the speed of its centre along a fixed axis).  FIRST:
## numbers of speeds that are wanted among them.

function [q, u] = free_velocities (m, t, x, first)
  d = m.sizes;
  [P, H] = gs.linear.constraint_rows (m, t, x);
  u = leading (gs.linear.null_space (H), first);
  q = u;
  if (! (d.nq == d.nu && d.nlam == 0))
    pairs = d.nq == d.nu && rank (P, 1e-9) == rank (H, 1e-9);
    wanted = merge (pairs, u, first(first <= d.nq));
    q = leading (gs.linear.null_space (P), wanted);
  endif
  kept = first(ismember (first, u));
  others_ = setdiff (1:d.nu, kept);
  n = numel (u) - numel (kept);
  if (d.nlam == 0 || rank (P, 1e-9) == rank (H, 1e-9) || nchoosek (numel (others_), n) > 300)
    return;
  endif
  u = fewest (m, t, x, q, kept, nchoosek (others_, n), u);
endfunction

## of the CHOICES of further speeds those whose accelerations depend on the fewest coordinates,
## looked at beside X, where nothing vanishes by chance
function u = fewest (m, t, x, q, kept, choices, u)
  d = m.sizes;
  s = d.nq + (1:d.nu);
  x(1:d.nq) += 0.1 * sin (1:d.nq)' .* m.nominal(1:d.nq);
  x(s) += 0.1 * cos (1:d.nu)' .* m.nominal(s);
  x = m.prj (t, x);
  A = m.jac (t, x, zeros (d.nv, 1));
  least = Inf;
  for k = 1:rows (choices)
    try_ = sort ([kept, choices(k,:)]);
    [T, own] = tangent (m, t, x, q, try_);
    if (isempty (T))
      continue;
    endif
    D = A(d.nq + try_,:) * T(:,1:numel (q));
    count = sum ((abs (D) > 1e-9 * max (max (abs (D), [], 2), 1e-9))(:)) - 0.9 / norm (T);
    if (count < least)
      [least, u] = deal (count, try_);
    endif
  endfor
endfunction

function [T, own] = tangent (m, t, x, q, u)
  d = m.sizes;
  [P, H, K] = gs.linear.constraint_rows (m, t, x);
  own = [q, d.nq + u, d.nq + d.nu + 1:d.nx];
  N = null (K, 1e-9);
  T = [];
  if (columns (N) == numel (own) && rcond (N(own,:)) > 1e-6)
    T = N / N(own,:);
  endif
endfunction

## rows of N that are independent: the FIRST ones as far as they are, then those that tell most
function k = leading (N, first)
  k = [];
  for i = first(:)'
    if (numel (k) < columns (N) && rank (N([k, i],:), 1e-7) > numel (k))
      k(end+1) = i;
    endif
  endfor
  Q = gs.linear.null_space (N(k,:));
  [~, ~, order] = qr ((N * Q)', "vector");
  k = sort ([k, order(1:columns (Q))]);
endfunction
