## x = gsmbp__settle (m, t, x)
## The state X of the model M with the states that the JSON calls settled where their
## rates vanish at the time T [s] and with all inputs zero, the others as they are.
## What they read is taken where the constraints are fulfilled: beside them it would
## hold what stabilizes the constraints. Where there is no such place (or no RHS) X
## comes back.

function x = gsmbp__settle (m, t, x)
  if (! isfield (m.json, "settled") || isempty (m.json.settled) ...
      || ! any (strcmp (m.subroutines, "rhs")))
    return;
  endif
  own = double (m.json.settled(:));
  v = zeros (m.sizes.nv, 1);
  y = on_constraints (m, t, x);
  for iteration = 1:20
    [f, ~] = m.rhs (t, y, v);
    J = zeros (numel (own));
    for k = 1:numel (own)
      z = y;
      z(own(k)) += 1e-3 * m.nominal(own(k));
      [g, ~] = m.rhs (t, z, v);
      J(:,k) = (g(own) - f(own)) / (z(own(k)) - y(own(k)));
    endfor
    if (! all (isfinite ([J(:); f(own)])) || rank (J) < numel (own))
      return;
    endif
    step = J \ f(own);
    y(own) -= step;
    if (all (abs (step) <= 1e-12 * (m.nominal(own) + abs (y(own)))))
      x(own) = y(own);
      return;
    endif
  endfor
endfunction

## the state with its coordinates and speeds moved onto the constraints, if that can be
function y = on_constraints (m, t, x)
  y = x;
  if (! any (strcmp (m.subroutines, "prj")))
    return;
  endif
  [moved, ~, info] = m.prj (t, x);
  if (info == 0 && all (isfinite (moved)))
    y = moved;
  endif
endfunction
