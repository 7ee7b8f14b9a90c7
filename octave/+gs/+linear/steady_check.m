## gs.linear.steady_check (p, z)
## An error where the solution Z of the problem P is steady at one instant alone: some time later,
## with the coordinates that run moved on, the same rates have to vanish.

function steady_check (p, z)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = gs.linear.rest_state (p, z);
  xd = m.rhs (p.t, x, v);
  names = gs.text.rest_names (p);
  for later = [0.618, 3.7]
    y = x;
    y(p.running) += later * xd(p.running);
    y = gs.linear.follow_rest (m, p.t + later, y, p.free_coordinates, p.free_speeds);
    [f, limit] = rates_at (p, y, v, p.t + later);
    k = find (! (abs (f) <= 100 * limit), 1);
    if (! isempty (k))
      error (["%s: %s: no steady motion: while %s run%s on, the %s does not stay zero: %.3g " ...
              "after %g s"], p.who, m.name, strjoin (m.coordinates(p.running)', ", "),
             {"s", ""}{1 + (numel (p.running) > 1)}, names{k}, f(k), later);
    endif
  endfor
endfunction

function [f, limit] = rates_at (p, x, v, t)
  p.x = x;
  p.v = v;
  z = [x(p.own)(:); v(p.inputs)(:)];
  [f, J] = gs.linear.rest_equations (p, z, t);
  limit = max (p.tolerance * p.usual, 1e3 * eps * (abs (J) * max (abs (z), p.size)));
endfunction
