## [best, word] = gs.linear.rest_solve (p)
## The problem P by one method after the other; WORD: the one that found BEST.

function [best, word] = rest_solve (p)
  best = p.z;
  word = "newton";
  if (isempty (best))   # all is held: it is an equilibrium, or none
    return;
  endif
  for way = {"newton", "levenberg", "transient"; @gs.linear.rest_newton, @levenberg, @transient}
    z = way{2} (p, p.z);
    if (gs.linear.rest_worst (p, z) < gs.linear.rest_worst (p, best))
      best = z;
    endif
    word = way{1};
    if (gs.linear.rest_worst (p, best) <= 1)
      return;
    endif
  endfor
endfunction

## least squares in scaled equations, where Newton's method stands still: regularized, so that a
## derivative that vanishes does no harm
function z = levenberg (p, z)
  mu = 1e-3;
  for k = 1:200
    [f, J] = gs.linear.rest_equations (p, z);
    row = max (abs (J) * p.size, p.usual);
    [K, g] = deal (J .* p.size' ./ row, f ./ row);
    if (! all (isfinite ([K(:); g])))
      return;
    endif
    step = -[K; sqrt(mu) * eye(columns (K))] \ [g; zeros(columns (K), 1)];
    next = z + gs.linear.rest_bound (p, step) * step .* p.size;
    if (norm (gs.linear.rest_equations (p, next) ./ row) < norm (g))
      z = next;
      mu /= 5;
    else
      mu *= 4;
    endif
    if (mu > 1e12 || norm (step, Inf) < 1e-8)
      break;
    endif
  endfor
  z = gs.linear.rest_newton (p, z);
endfunction

## the motion itself by implicit Euler steps that grow as it comes to rest: it ends in a stable
## equilibrium
function z = transient (p, z)
  [m, d] = deal (p.m, p.m.sizes);
  if (isempty (p.own) || ! isempty (p.steady))
    return;   # no state may move, or some go on moving
  endif
  moving = setdiff (1:d.nx, [p.held, d.nq + p.held(p.held <= d.nq & d.nq == d.nu)]);
  size = m.nominal(moving);
  [x, v] = gs.linear.rest_state (p, z);
  for k = 1:300
    [xd, ~] = m.rhs (p.t, x, v);
    [A, ~, ~, ~, ~] = m.jac (p.t, x, v);
    K = A(moving,moving) .* size' ./ size;
    f = xd(moving) ./ size;
    if (! all (isfinite ([K(:); f])) || norm (f) == 0)
      break;
    endif
    if (k == 1)
      h = least = 0.3 / norm (f);
    else
      h = max (least, h * min (2, max (0.5, before / norm (f))));
    endif
    before = norm (f);
    step = (eye (numel (f)) / h - K) \ f;
    x(moving) += size .* step / max (1, 2 * norm (step(moving <= d.nq), Inf));
    if (d.nlam > 0 || d.nq > d.nu)
      [x, ~, ~] = m.prj (p.t, x);
    endif
  endfor
  z = gs.linear.rest_newton (p, [x(p.own); v(p.inputs)]);
endfunction
