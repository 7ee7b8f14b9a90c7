## K = gs.control.placed_poles (who, A, B, poles)
## The gain with which A - B K has these POLES, by the control package on balanced states; an error
## of WHO where it has not.

function K = placed_poles (who, A, B, poles)
  n = rows (A);
  if (n == 0)
    K = zeros (columns (B), 0);
    return;
  endif
  X = A;
  X(abs (X) < 1e-14 * max (abs (X(:)))) = 0;
  [S, ~] = balance (X);
  S = diag (max (abs (S), [], 2));
  [A, B] = deal (S \ A * S, S \ B);
  if (columns (B) == 1)
    K = single_input (A, B, poles);
  else
    K = place (A, B, poles(:));
  endif
  found = eig (A - B * K);
  wanted = poly (poles);
  away = abs (poly (found) - wanted) ./ poly (-abs (poles) - 0.01 * max (abs (poles)));
  if (! all (away <= 1e-6))
    error (["%s: the poles %s cannot be placed: expected states that the inputs (or the " ...
            "measurements) reach; found poles %s"], who, gs.text.pole_text (poles, 0), ...
           gs.text.pole_text (found, 0));
  endif
  K = K / S;
endfunction

## one input: Ackermann's formula in the Hessenberg form of A with B along the first axis, where
## its last row is a product of factors; refined once from the loop that it gives
function K = single_input (A, b, poles)
  n = rows (A);
  K = zeros (1, n);
  for pass = 1:2
    K += ackermann (A - b * K, b, poles);
  endfor
endfunction

function K = ackermann (A, b, poles)
  n = rows (A);
  [Q, H] = staircase (A, b);
  row = zeros (1, n);
  row(n) = 1;
  s = poles(:).';
  while (! isempty (s))
    [row, s] = times_factor (row, H, s);
  endwhile
  scale = prod (H(2:n+1:n*(n-1))) * (Q(:,1)' * b);   # the subdiagonal
  K = row / scale * Q';
  if (! all (isfinite (K)))
    K = zeros (1, n);
  endif
endfunction

## row * (H - s I), a conjugate pair at once
function [row, s] = times_factor (row, H, s)
  if (imag (s(1)) == 0)
    row = row * H - s(1) * row;
    s(1) = [];
    return;
  endif
  [~, k] = min (abs (s - conj (s(1))));
  row = (row * H) * H - 2 * real (s(1)) * (row * H) + abs (s(1)) ^ 2 * row;
  s([1, k]) = [];
endfunction

## Q' A Q = H upper Hessenberg, Q' b along the first axis
function [Q, H] = staircase (A, b)
  n = rows (A);
  [Q, ~] = qr (b);
  [P, H] = hess (Q' * A * Q);
  Q = Q * P;
endfunction
