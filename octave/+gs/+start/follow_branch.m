## [x, reached] = gs.start.follow_branch (m, t, x, held)
## Follow the branch of the guess X of the model M at the time T: close the loops near the guess,
## with no coordinate held, and move the coordinates HELD (a mask) from there to their values in X
## in small steps.  REACHED is the share of this path that the branch covers: 1 all of it, NaN
## where no closed pose is near the guess or where the held coordinates depend on each other.
## Source: numerical continuation with a tangent predictor and Newton's corrector, whose steps are
## shorter where the corrector is slow (Allgower and Georg, Introduction to Numerical Continuation
## Methods, 1990, chapter 6).

function [x, reached] = follow_branch (m, t, x, held)
  reached = NaN;
  target = x(held);
  [x, closed] = nearby (m, t, x, held);
  if (! closed || dependent (m, t, x, held))
    return;
  endif
  first = x(held);
  reached = 0;
  step = 1;
  while (reached < 1 && step > 1e-6)
    next = min (1, reached + step);
    [moved, kept] = advanced (m, t, x, held, first + next * (target - first));
    if (kept)
      [x, reached] = deal (moved, next);
      step *= 2;
    else
      step /= 4;
    endif
  endwhile
endfunction

## a closed pose near the guess: the held coordinates go where the others fit best, then all follow
function [x, closed] = nearby (m, t, x, held)
  x = approached (m, t, x, held);
  [x, gap] = approached (m, t, x, true (m.sizes.nq, 1));
  closed = gap <= 1e-9;
endfunction

## the constraints made small by the coordinates MOVING: Gauss and Newton, each step shortened until
## the gap falls
function [x, gap] = approached (m, t, x, moving)
  [H, K, phi] = gs.start.loop_jacobian (m, t, x);
  gap = norm (phi);
  for iteration = 1:60
    some = any (abs (K(moving,:)) > 1e-12, 1);
    move = K(:,some) * (pinv (H(:,some)) * -phi);
    move /= max (1, 2 * extent (m, move));
    do
      near = displaced (m, x, move);
      [H, K, phi] = gs.start.loop_jacobian (m, t, near);
      move /= 2;
    until (norm (phi) < gap || extent (m, move) < 1e-12)
    if (! (norm (phi) < gap))
      return;
    endif
    [x, gap] = deal (near, norm (phi));
  endfor
endfunction

## whether the constraints leave the held coordinates fewer freedoms than their number
function yes = dependent (m, t, x, held)
  [H, K] = gs.start.loop_jacobian (m, t, x);
  K = K(held,:);
  yes = rank ([H; K]) < rank (H) + rank (K);
endfunction

## the pose with the held coordinates at VALUES, by tangent and corrector; KEPT: the corrector's
## steps were small and fell quickly, thus the pose is on the branch of X
function [x, kept] = advanced (m, t, x, held, values)
  kept = false;
  [H, K] = gs.start.loop_jacobian (m, t, x);
  u = pinv ([H; K(held,:)]) * [zeros(rows (H), 1); values - x(held)];
  if (extent (m, K * u) > 0.5)
    return;
  endif
  x(1:m.sizes.nq) += K * u;
  x(held) = values;
  x = gs.start.unit_orientations (m, x);
  last = 0.2;
  for iteration = 1:8
    move = correction (m, t, x, held);
    x = displaced (m, x, move);
    kept = extent (m, move) <= 1e-10;
    if (kept || ! (extent (m, move) <= last))
      return;
    endif
    last = extent (m, move) / 2;
  endfor
endfunction

## the step of Newton's method with the held coordinates where they are
function move = correction (m, t, x, held)
  [H, K, phi] = gs.start.loop_jacobian (m, t, x);
  free = all (abs (K(held,:)) <= 1e-12, 1);
  move = K(:,free) * (pinv (H(:,free)) * -phi);
endfunction

function x = displaced (m, x, move)
  x(1:m.sizes.nq) += move;
  x = gs.start.unit_orientations (m, x);
endfunction

## the largest part of a displacement, by the nominal magnitudes
function size = extent (m, move)
  size = max (abs (move) ./ m.nominal(1:m.sizes.nq));
endfunction
