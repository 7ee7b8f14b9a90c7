## [A, xd] = gs.linear.held_jacobian (who, m, t, x, v, held)
## The Jacobian of the rates of the model M by its states and these rates, where efforts of any
## size hold speeds (the second column of HELD) as they are: the accelerations that these efforts
## give are taken out, with their own change by the coordinates.

function [A, xd] = held_jacobian (who, m, t, x, v, held)
  d = m.sizes;
  A = gs.linear.model_jacobian (who, m, t, x, v);
  xd = m.rhs (t, x, v);
  if (isempty (held))
    return;
  endif
  s = d.nq + (1:d.nu);
  h = held(:,2);
  [q, u] = deal (x(1:d.nq), x(s));
  M = m.mas (t, q);
  H = zeros (0, d.nu);
  if (d.nlam > 0)
    [~, ~, H] = m.con (t, q, u);
  endif
  N = gs.linear.null_space (H);
  S = N / (N' * M * N) * N';   # accelerations by efforts
  W = S(:,h);
  effort = -W(h,:) \ xd(s(h));
  w = W * effort;
  if (any (w != 0))
    A(s,1:d.nq) += moved (m, t, x, v, w, M, H, S, effort, h);
  endif
  A(s,:) -= W * (W(h,:) \ A(s(h),:));
  xd(s) += w;
endfunction

## the change by the coordinates of the accelerations W of EFFORT at the speeds H_
function D = moved (m, t, x, v, w, M, H, S, effort, h)
  d = m.sizes;
  [q, u] = deal (x(1:d.nq), x(d.nq + (1:d.nu)));
  [~, ~, C1] = m.lin (t, q, u, w, v);
  [~, ~, C0] = m.lin (t, q, u, zeros (d.nu, 1), v);
  R = C1 - C0;
  if (d.nlam == 0)
    D = -S * R;
    return;
  endif
  e = zeros (d.nu, 1);
  e(h) = effort;
  lambda = H' \ (M * w - e);
  rate = @(u) nthargout (2, 2, m.tan, t, [q; u; x(d.nq+d.nu+1:end)]);
  still = rate (zeros (d.nu, 1));
  for k = 1:d.nu
    R(k,:) -= lambda' * (rate ((1:d.nu)' == k) - still);
  endfor
  up = -pinv (H) * (rate (w) - still);
  D = up - S * (R + M * up);
endfunction
