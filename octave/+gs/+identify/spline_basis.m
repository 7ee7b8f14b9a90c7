## B = gs.identify.spline_basis (t, m)
## Return the values, first and second derivatives of the quintic B-splines of M equal intervals
## from T(1) to T(end), at the times T: three sparse matrices, a row for each time, M + 5 columns.

function B = spline_basis (t, m)
  h = (t(end) - t(1)) / m;
  at = (t(:) - t(1)) / h;
  piece = min (floor (at), m - 1);
  x = at - piece;
  n = numel (x);
  row = repmat ((1:n)', 1, 6);
  column = piece + (1:6);
  persistent quintic = pieces (5);
  P = quintic;
  B = cell (1, 3);
  for d = 0:2
    value = x .^ (5-d:-1:0) * P' / h ^ d;
    B{d+1} = sparse (row, column, value, n, m + 5);
    P = P(:,1:end-1) .* (5-d:-1:1);
  endfor
endfunction

## the polynomials in [0, 1] of the B-splines that are not zero there, by de Boor's recursion
function P = pieces (degree)
  P = 1;
  for d = 1:degree
    up = zeros (d + 1, d + 1);
    for j = 1:d
      up(j,:) += conv ([-1, j] / d, P(j,:));
      up(j+1,:) += conv ([1, d-j] / d, P(j,:));
    endfor
    P = up;
  endfor
endfunction
