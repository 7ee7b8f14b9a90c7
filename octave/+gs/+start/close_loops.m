## [x, complaint, other] = gs.start.close_loops (m, x, o, held, anywhere)
## Move the guess X of a state of M onto the constraints; COMPLAINT is "" or the reason why this
## failed, OTHER "" or the reason why X is not on the branch of the guess.  O: the options of
## gsmbp_assemble; HELD: a mask of the coordinates that stay; ANYWHERE: X may end on any branch.

function [x, complaint, other] = close_loops (m, x, o, held, anywhere = false)
  d = m.sizes;
  other = unreached = "";
  if (any (held))
    if (! anywhere)
      [near, reached] = gs.start.follow_branch (m, o.time, x, held);
      if (reached < 1)
        [other, unreached] = branch_end (m, near, x, held, o.branches > 0);
      elseif (reached == 1)
        x = near;
      else
        unreached = not_free (m, o.time, near, x, held);
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
  closed = gap <= o.tolerance && slip <= o.tolerance * max (1, norm (u));
  if (! closed && ! isempty (unreached))
    complaint = unreached;
  elseif (! (gap <= o.tolerance))
    complaint = sprintf (["the loop does not close: %s = %.6g is left of the constraints " ...
                          "(tolerance %g); try another guess, the option \"branches\", or " ...
                          "check the lengths%s"], label (m, k), phi(k), o.tolerance, ...
                         gs.text.not_finite_value ([phi; rate]));
  elseif (! (slip <= o.tolerance * max (1, norm (u))))
    complaint = sprintf ("the speeds do not fit the constraints: the rate of %s is %.6g%s", ...
                         label (m, j), rate(j), gs.text.not_finite_value (rate));
  endif
endfunction

## Newton on what is not held, by displacements of the speeds; then the speeds
function x = solve (m, x, o, held)
  d = m.sizes;
  x = gs.start.unit_orientations (m, x);
  u = x(d.nq + (1:d.nu));
  least = Inf;
  for iteration = 1:60
    q = x(1:d.nq);
    [H, K, phi] = gs.start.loop_jacobian (m, o.time, x);
    if (norm (phi, Inf) < least)
      least = norm (phi, Inf);
      best = x;
    endif
    free = free_speeds (K, held);
    step = -pinv (H(:,free)) * phi;
    move = K(:,free) * step / max (1, max (abs (step)));
    x(1:d.nq) += move;
    x = gs.start.unit_orientations (m, x);
    if (norm (move, Inf) <= 1e-15 * max (1, norm (q, Inf)) || norm (phi, Inf) == 0)
      break;
    endif
  endfor
  [~, K, phi] = gs.start.loop_jacobian (m, o.time, x);
  if (norm (phi, Inf) > least)
    x = best;
  endif
  [~, phit, H, ~, ~] = m.con (o.time, x(1:d.nq), u);
  free = free_speeds (K, held);
  u(free) -= pinv (H(:,free)) * (H * u + phit);
  x(d.nq + (1:d.nu)) = u;
endfunction

## where the branch of the guess ends: the state NEAR, before the held coordinates are as in X;
## UNREACHED: for values that no branch was found to reach; ALL_: of all branches
function [text, unreached] = branch_end (m, near, x, held, all_)
  [~, k] = max (abs (x - near)(find (held)));
  k = find (held)(k);
  unreached = sprintf (["option hold: expected %s %s %.6g, where the branch of the guess ends; " ...
                        "found %.6g, with which the loops do not close"], m.coordinates{k}, ...
                       {"at least", "at most"}{1 + (x(k) > near(k))}, near(k), x(k));
  if (! all_)
    unreached = [unreached "; other branches: option \"branches\""];
  endif
  text = sprintf (["option hold: expected %s = %.6g on the branch of the guess; found its end " ...
                   "at %s = %.6g; another branch reaches it: list them with \"branches\", 20"], ...
                  m.coordinates{k}, x(k), m.coordinates{k}, near(k));
endfunction

## coordinates that may not be held: driven or fixed by the constraints, or more of them than the
## loops leave degrees of freedom; NEAR: the closed pose near the guess X; "" where they may be
function text = not_free (m, t, near, x, held)
  text = "";
  [H, K, phi] = gs.start.loop_jacobian (m, t, near);
  if (norm (phi, Inf) > 1e-8)
    return;
  endif
  for k = find (held)'
    if (rank ([H; K(k,:)]) == rank (H))
      text = sprintf (["option hold: %s is %s, at the time %g to %.6g; found %.6g; leave it " ...
                       "out of hold, or take another time (option time)"], m.coordinates{k}, ...
                      by_what (m, H, K(k,:)), t, near(k), x(k));
      return;
    endif
  endfor
  left = rank ([H; K(held,:)]) - rank (H);
  if (left < sum (held))
    text = sprintf (["option hold: the loops leave %d degree(s) of freedom to %s; expected at " ...
                     "most as many coordinates to hold, found %d"], left, ...
                    strjoin (m.coordinates(held)', ", "), sum (held));
  endif
endfunction

## the row of the constraints that states one coordinate alone, K of its rate
function text = by_what (m, H, K)
  text = "fixed by the constraints";
  for row = 1:rows (H)
    if (any (H(row,:)) && ! any (H(row,K == 0)))
      text = sprintf ("driven (%s)", label (m, row));
      return;
    endif
  endfor
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
