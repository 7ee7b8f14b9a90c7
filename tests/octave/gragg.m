## y = gragg (F, T, H, N, X): x' = F(t, x) from X at T(1), a column for each of the times T: steps
## of H, modified midpoint rule with 2, 4, .. 2*N substeps, extrapolated (Gragg, Bulirsch and
## Stoer). Written for the tests, apart from the run time's integrators.

function y = gragg (f, t, h, n, x)
  y = x;
  for k = 2:numel (t)
    steps = ceil ((t(k) - t(k-1)) / h - 1e-9);
    H = (t(k) - t(k-1)) / steps;
    for s = 0:steps - 1
      x = gragg_step (f, t(k-1) + s * H, H, n, x);
    end
    y(:,k) = x;
  end
end

function x = gragg_step (f, t, H, n, x)
  T = cell (1, n);
  f0 = f (t, x);
  for j = 1:n
    h = H / (2 * j);
    a = x;
    b = x + h * f0;
    for i = 1:2 * j - 1
      [a, b] = deal (b, a + 2 * h * f (t + i * h, b));
    end
    T{j} = 0.5 * (a + b + h * f (t + H, b));
    for l = j-1:-1:1
      T{l} = T{l+1} + (T{l+1} - T{l}) / ((j / l) ^ 2 - 1);
    end
  end
  x = T{1};
end
