## z = gs.linear.rest_newton (p, z)
## Newton's method, damped, on the problem P from Z.

function z = rest_newton (p, z)
  damping = 1;
  for k = 1:200
    [correct, good] = corrector (p, z);
    step = correct (gs.linear.rest_equations (p, z));
    if (! good || norm (step) == 0)
      return;
    endif
    [next, damping] = damped (p, z, step, correct, damping);
    if (isempty (next))
      return;
    endif
    if (norm (step, Inf) < 1e-7 && ...
          norm (correct (gs.linear.rest_equations (p, next))) >= norm (step) / 2)
      return;   # rounding: nothing is gained any more
    endif
    z = next;
  endfor
endfunction

## Newton's correction in units of the usual sizes, by an inverse that leaves out what moves nothing
function [correct, good] = corrector (p, z)
  [f, J] = gs.linear.rest_equations (p, z);
  row = abs (J) * p.size;
  row(! (row > 0)) = 1;
  K = J .* p.size' ./ row;
  K(:,p.fixed) = 0;
  good = all (isfinite (K(:))) && all (isfinite (f));
  if (! good)
    correct = @(f) NaN (numel (z), 1);
    return;
  endif
  inverse = pinv (K, 1e-12 * max ([norm(K), realmin]));
  inverse(p.fixed,:) = 0;
  correct = @(f) -inverse * (f ./ row);
endfunction

function [next, damping] = damped (p, z, step, correct, damping)
  damping = min ([1, 4 * damping, gs.linear.rest_bound(p, step)]);
  while (damping > 1e-9)
    next = z + damping * step .* p.size;
    after = norm (correct (gs.linear.rest_equations (p, next)));
    if (after <= (1 - damping / 4) * norm (step) || (damping == 1 && norm (step, Inf) < 1e-7))
      return;
    endif
    damping /= 2;
  endwhile
  next = [];
endfunction
