## X = speed_states (s, kind, count): states by chance, n x 4 x COUNT: q [rad], q' [rad/s], q''
## [rad/s^2], tau [N*m]. kind "random"; "fast", speeds up to 2e4 rad/s; "singular", all joints
## within 1e-7 of stretched or folded.

function X = speed_states (s, kind, count)
  n = s.n;
  rand ("twister", [n, count, double(kind)]);
  X = 2 * rand (n, 4, count) - 1;
  X .*= [pi, 2, 5, 10];
  if (strcmp (kind, "fast"))
    X(:,2,:) *= 1e4;
  elseif (strcmp (kind, "singular"))
    X(:,1,:) = pi * (rand (n, 1, count) > 0.5) + 1e-7 * (2 * rand (n, 1, count) - 1);
  end
  if (s.loop)
    X = closed (X);
  end
end

## q and q' of the slider-crank (0.1 m and 0.3 m) that close its loop
function X = closed (X)
  [l1, l2] = deal (0.1, 0.3);
  [q, u] = deal (X(1,1,:), X(1,2,:));
  rod = -asin (l1 / l2 * sin (q));
  turn = -l1 * cos (q) .* u ./ (l2 * cos (rod));
  X(:,1,:) = [q; rod - q; l1 * cos(q) + l2 * cos(rod)];
  X(:,2,:) = [u; turn - u; -l1 * sin(q) .* u - l2 * sin(rod) .* turn];
end
