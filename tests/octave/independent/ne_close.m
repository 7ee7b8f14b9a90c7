## [q, u, ud] = ne_close (M, GUESS, INDEPENDENT, U, UD): the motion that closes the loops:
## coordinates INDEPENDENT keep their values in GUESS (and in U, UD), the others follow by Newton's
## method and by the linear loop conditions on speeds and accelerations. Joints without Euler
## parameters.

function [q, u, ud] = ne_close (m, guess, independent, u, ud)
  n = numel (guess);
  free = setdiff (1:n, independent);
  q = guess(:);
  for step = 1:50
    k = ne_rows (m, q, zeros (n, 1));
    H = ne_jacobian (k);
    change = H(:, free) \ k.gap;
    q(free) -= change;
    if (norm (change) < 1e-15 * (1 + norm (q)))
      break;
    end
  end
  u = u(:);
  u(free) = -H(:, free) \ (H(:, independent) * u(independent));
  [H, gamma] = ne_jacobian (ne_rows (m, q, u));
  ud = ud(:);
  ud(free) = H(:, free) \ (gamma - H(:, independent) * ud(independent));
end
