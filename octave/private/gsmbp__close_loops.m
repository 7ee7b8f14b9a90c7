## [x, complaint, other] = gsmbp__close_loops (m, x, o, held, anywhere)
## Move the guess X of a state of M onto the constraints; COMPLAINT is "" or the reason why this
## failed, OTHER "" or the reason why X is not on the branch of the guess.  O: the options of
## gsmbp_assemble; HELD: a mask of the coordinates that stay; ANYWHERE: X may end on any branch.

function [x, complaint, other] = gsmbp__close_loops (m, x, o, held, anywhere = false)
  d = m.sizes;
  other = "";
  if (any (held))
    if (! anywhere)
      [near, reached] = gsmbp__follow_branch (m, o.time, x, held);
      if (reached < 1)
        other = branch_end (m, near, x, held);
      elseif (reached == 1)
        x = near;
      endif
    endif
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
                          "(tolerance %g); try another guess, the option \"branches\", or " ...
                          "check the lengths%s"], label (m, k), phi(k), o.tolerance, ...
                         gsmbp__nowhere ([phi; rate]));
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
  least = Inf;
  for iteration = 1:60
    q = x(1:d.nq);
    [H, K, phi] = gsmbp__loop_jacobian (m, o.time, x);
    if (norm (phi, Inf) < least)
      least = norm (phi, Inf);
      best = x;
    endif
    free = free_speeds (K, held);
    step = -pinv (H(:,free)) * phi;
    move = K(:,free) * step / max (1, max (abs (step)));
    x(1:d.nq) += move;
    x = gsmbp__unit_orientations (m, x);
    if (norm (move, Inf) <= 1e-15 * max (1, norm (q, Inf)) || norm (phi, Inf) == 0)
      break;
    endif
  endfor
  [~, K, phi] = gsmbp__loop_jacobian (m, o.time, x);
  if (norm (phi, Inf) > least)
    x = best;
  endif
  [~, phit, H, ~, ~] = m.con (o.time, x(1:d.nq), u);
  free = free_speeds (K, held);
  u(free) -= pinv (H(:,free)) * (H * u + phit);
  x(d.nq + (1:d.nu)) = u;
endfunction

## where the branch of the guess ends: the state NEAR, before the held coordinates are as in X
function text = branch_end (m, near, x, held)
  [~, k] = max (abs (x - near)(find (held)));
  k = find (held)(k);
  text = sprintf (["option hold: expected %s = %.6g on the branch of the guess; found its end " ...
                   "at %s = %.6g; another branch reaches it: list them with \"branches\", 20"], ...
                  m.coordinates{k}, x(k), m.coordinates{k}, near(k));
endfunction

## the speeds that move nothing that is held; K: of q' = K*u
function free = free_speeds (K, held)
  free = all (abs (K(held,:)) <= 1e-12, 1);
endfunction

function text = label (m, k)
  text = sprintf ("phi(%d)", k);
  if (numel (m.multipliers) >= k)
    text = sprintf ("phi of %s", m.multipliers{k});
  endif
endfunction
