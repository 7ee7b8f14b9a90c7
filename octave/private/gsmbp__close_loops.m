## [x, complaint] = gsmbp__close_loops (m, x, o, held)
## The guess X of a state of M moved onto the constraints, COMPLAINT "" or why not.  O: the options
## of gsmbp_assemble; HELD: numbers of the coordinates that stay.

function [x, complaint] = gsmbp__close_loops (m, x, o, held)
  d = m.sizes;
  if (any (held))
    x = solve (m, x, o, held);
  else
    [x, ~, info] = m.prj (o.time, x);
  endif
  phi = rate = Inf (d.nlam, 1);
  if (all (abs (x) <= 1e300))
    u = x(d.nq + (1:d.nu));
    [phi, phit, H, ~, ~] = m.con (o.time, x(1:d.nq), u);
    rate = H * u + phit;
  endif
  complaint = "";
  [gap, k] = max (abs (phi));
  [slip, j] = max (abs (rate));
  if (! (gap <= o.tolerance))
    complaint = sprintf (["the loop does not close: %s = %.6g is left of the constraints " ...
                          "(tolerance " ...
                          "%g); try another guess or check the lengths%s"], label (m, k), ...
                         phi(k), o.tolerance, gsmbp__nowhere ([phi; rate]));
  elseif (! (slip <= o.tolerance * max (1, norm (u))))
    complaint = sprintf ("the speeds do not fit the constraints: the rate of %s is %.6g%s", ...
                         label (m, j), rate(j), gsmbp__nowhere (rate));
  endif
endfunction

## Newton on what is not held, by displacements of the speeds; then the speeds
function x = solve (m, x, o, held)
  d = m.sizes;
  x = gsmbp__unit_orientations (m, x);
  u = x(d.nq + (1:d.nu));
  rows = setdiff (1:d.nlam, m.speed_rows);   # the others have no phi
  least = Inf;
  for iteration = 1:60
    q = x(1:d.nq);
    [phi, ~, H, ~, ~] = m.con (o.time, q, u);
    if (norm (phi, Inf) < least)
      least = norm (phi, Inf);
      best = x;
    endif
    [K, free] = moves (m, o.time, q, held);
    step = -pinv (H(rows,free)) * phi(rows);
    move = K(:,free) * step / max (1, max (abs (step)));
    x(1:d.nq) += move;
    x = gsmbp__unit_orientations (m, x);
    if (norm (move, Inf) <= 1e-15 * max (1, norm (q, Inf)) || norm (phi, Inf) == 0)
      break;
    endif
  endfor
  if (norm (m.con (o.time, x(1:d.nq), u), Inf) > least)
    x = best;
  endif
  [~, phit, H, ~, ~] = m.con (o.time, x(1:d.nq), u);
  [~, free] = moves (m, o.time, x(1:d.nq), held);
  u(free) -= pinv (H(:,free)) * (H * u + phit);
  x(d.nq + (1:d.nu)) = u;
endfunction

## q' = K*u, and which speeds move nothing that is held
function [K, free] = moves (m, t, q, held)
  d = m.sizes;
  if (d.nq == d.nu && ! any (strcmp (m.subroutines, "kin")))
    K = eye (d.nu);
  else
    e = eye (d.nu);
    for j = d.nu:-1:1
      K(:,j) = m.kin (t, q, e(:,j));
    endfor
  endif
  free = all (abs (K(held,:)) <= 1e-12, 1);
endfunction

function text = label (m, k)
  text = sprintf ("phi(%d)", k);
  if (numel (m.multipliers) >= k)
    text = sprintf ("phi of %s", m.multipliers{k});
  endif
endfunction
