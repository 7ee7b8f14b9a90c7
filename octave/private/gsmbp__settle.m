## x = gsmbp__settle (m, t, x)
## The state X of the model M with the states that the JSON calls settled where their
## rates vanish at the time T [s] and with all inputs zero, the others as they are.
## Where there is no such place (or no RHS) X comes back.

function x = gsmbp__settle (m, t, x)
  if (! isfield (m.json, "settled") || isempty (m.json.settled) ...
      || ! any (strcmp (m.subroutines, "rhs")))
    return;
  endif
  own = double (m.json.settled(:));
  v = zeros (m.sizes.nv, 1);
  y = x;
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
      x = y;
      return;
    endif
  endfor
endfunction
