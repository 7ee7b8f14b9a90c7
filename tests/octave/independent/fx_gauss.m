## [X, W] = fx_gauss (N): points and weights of Gauss's formula on 0 to 1 (Golub, Welsch), as rows.

function [x, w] = fx_gauss (n)
  b = (1:n-1) ./ sqrt (4 * (1:n-1) .^ 2 - 1);
  [V, D] = eig (diag (b, 1) + diag (b, -1));
  x = (1 + diag (D)') / 2;
  w = V(1, :) .^ 2;
end
