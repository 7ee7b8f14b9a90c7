## [rows, rank] = gs.start.lost_rank (m, t, x)
## The rows of the constraints of M that depend on each other at T [s] and X and not elsewhere, {}
## where the rank is what it is in general (m.mobility); RANK: how many are independent, to 1e-4 of
## the largest singular value, each row measured by its length there or at the scene's start.

function [rows, rank] = lost_rank (m, t, x)
  d = m.sizes;
  rows = {};
  rank = 0;
  if (d.nlam == 0 || ! isfield (m, "mobility") || ! isfield (m.mobility, "rank"))
    return;
  endif
  [~, ~, H] = m.con (t, x(1:d.nq), zeros (d.nu, 1));
  [~, ~, first] = m.con (t, m.initial(1:d.nq), zeros (d.nu, 1));
  size_ = sqrt (max (sum (H .^ 2, 2), sum (first .^ 2, 2)));
  size_(size_ == 0) = 1;
  [U, S] = svd (H ./ size_);
  n = min (size (S));
  s = [diag(S(1:n,1:n)); zeros(d.nlam - n, 1)];
  rank = sum (s > 1e-4 * max ([s; eps]));
  if (rank < m.mobility.rank)
    lost = rank + 1:m.mobility.rank;
    rows = gs.text.constraint_names (m);
    rows = rows(any (abs (U(:,lost)) > 0.1, 2))';
  endif
endfunction
