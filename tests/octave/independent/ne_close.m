## [q, u, ud] = ne_close (M, GUESS, INDEPENDENT, U, UD): the motion that closes the loops: coordinates INDEPENDENT keep their values in GUESS (and in U, UD), the
## others follow by Newton's method and by the linear loop conditions on speeds and accelerations.

function [q, u, ud] = ne_close (m, guess, independent, u, ud)
  n = numel (m.body);
  free = setdiff (1:n, independent);
  q = guess(:);
  for step = 1:50
    k = ne_rows (m, q, zeros (n, 1));
    H = k.L * (k.J \ k.E);
    change = H(:, free) \ k.gap;
    q(free) -= change;
    if (norm (change) < 1e-15 * (1 + norm (q)))
      break;
    end
  end
  u = u(:);
  u(free) = -H(:, free) \ (H(:, independent) * u(independent));
  k = ne_rows (m, q, u);
  H = k.L * (k.J \ k.E);
  ud = ud(:);
  ud(free) = H(:, free) \ (k.gamma_loop - k.L * (k.J \ k.gamma) - H(:, independent) * ud(independent));
end
