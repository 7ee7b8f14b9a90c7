## [q, left] = ne_assemble (M, GUESS, T, STEPS): coordinates near GUESS that close all loops and
## satisfy what is given on them, by Newton's method with steps of least norm (half a unit at most);
## rows may depend on each other (only near a closed position, if m.redundant is true). LEFT: the
## largest gap that is left after STEPS (default 60).

function [q, left] = ne_assemble (m, guess, t, steps)
  if (nargin < 3)
    t = 0;
  end
  if (nargin < 4)
    steps = 60;
  end
  small = 1e-9;
  if (isfield (m, "redundant") && m.redundant)
    small = 0.05;
  end
  q = guess(:);
  left = Inf;
  for step = 1:steps
    k = ne_rows (m, q, "still", t);
    gap = [k.gap; k.gap_user];
    now = max ([0; abs(gap)]);
    if (now == 0 || (now >= left && now < 1e-13))
      break;
    end
    left = now;
    H = ne_jacobian (k);
    if (! all (isfinite ([H(:); gap])))   # a disc that lies flat
      left = Inf;
      return;
    end
    [U, S, V] = svd (H, "econ");
    s = diag (S);
    keep = s > small * max ([1; s]);
    dx = -V(:, keep) * ((U(:, keep)' * gap) ./ s(keep));
    q = ne_advance (m, q, dx * min (1, 0.5 / max (abs (dx))));
  end
  left = min (left, now);
end
