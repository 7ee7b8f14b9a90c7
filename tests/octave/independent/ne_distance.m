## [d, rate] = ne_distance (K, SPRING): distance of the ends of a spring between two points, and its
## rate, from k = ne_rows (...).

function [d, rate] = ne_distance (k, spring)
  [xA, vA] = point (k, spring.a, spring.point_a);
  [xB, vB] = point (k, spring.b, spring.point_b);
  d = norm (xB - xA);
  rate = (xB - xA)' * (vB - vA) / d;
end

function [x, v] = point (k, b, X)
  x = X;
  v = zeros (3, 1);
  if (b)
    x = k.origin(:, b) + k.R(:, :, b) * X;
    v = k.v(:, b) + ne_cross (k.w(:, b), x - k.com(:, b));
  end
end
