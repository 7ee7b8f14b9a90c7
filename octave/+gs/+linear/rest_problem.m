## p = gs.linear.rest_problem (m, x, v, o)
## What gsmbp_trim solves: unknowns, sizes, what is held; O: its options.

function p = rest_problem (m, x, v, o)
  p = struct ("who", "gsmbp_trim", "m", m, "t", o.time, "tolerance", o.tolerance);
  d = m.sizes;
  if (! any (strcmp (m.subroutines, "jac")))
    gs.given.need_jacobian (p.who, m);
  endif
  x = gs.given.given_guess (p.who, m, "x", x, m.initial(d.nq + 1:d.nx));
  if (isempty (o.steady))
    x(d.nq + (1:d.nu)) = 0;
  endif
  if (isempty (v))
    v = zeros (d.nv, 1);
  endif
  named = sprintf (" (the inputs %s)", strjoin (m.inputs', ", "));
  v = gs.given.given_vector (p.who, "v", v, d.nv, named, m.inputs);
  held = places (p.who, o.hold, m.states, "hold", "a state");
  [p.inputs, speeds] = free_ones (p.who, m, o);
  p.own = setdiff ([1:d.nq, d.nq + d.nu + 1:d.nx], held);
  p.held = held;
  given = x;
  if (d.nlam > 0 || d.nq > d.nu)
    x = closed (m, x, held, o.time);
  endif
  p.x = x;
  p.v = v;
  p.rows = d.nq + 1:d.nx;   # the rates that vanish
  p.running = [];
  p.steady = [];
  if (! isempty (o.steady))
    p.x(d.nq + (1:d.nu)) = given(d.nq + (1:d.nu));
    p = gs.linear.steady_problem (p, o.steady, speeds);
  endif
  p.fixed = [];   # unknowns that stay where they are
  p.z = [p.x(p.own)(:); v(p.inputs)(:)];
  p.size = [m.nominal(p.own)(:); ones(numel (p.inputs), 1)];
  p.usual = [m.nominal(p.rows); ones(d.nlam * (1 + ! isempty (p.steady)) + ...
                                     rows (m.orientation), 1)];
  p.size = sizes (p);
endfunction

## a free input counts by what moves the rates as much as the usual sizes of the states do
function s = sizes (p)
  s = p.size;
  n = numel (p.own);
  [~, J] = gs.linear.rest_equations (p, p.z);
  if (! all (isfinite (J(:))))
    return;
  endif
  row = abs (J(:,1:n)) * s(1:n)(:);
  for k = n + (1:numel (p.inputs))
    reach = max (row, p.usual) ./ abs (J(:,k));
    least = min (reach(isfinite (reach) & reach > 0));
    if (! isempty (least))
      s(k) = max (least, abs (p.z(k)));
    endif
  endfor
endfunction

## numbers of the inputs, and of the speeds of a steady motion, that are free
function [inputs, speeds] = free_ones (who, m, o)
  gs.given.refuse_mode_names (who, "option free", m, gs.given.asked_names (o.free));
  if (isempty (o.steady))
    inputs = places (who, o.free, m.inputs, "free", "an input")(:)';
    speeds = [];
    return;
  endif
  known = [m.inputs(:); m.speeds(:)];
  k = places (who, o.free, known, "free", "an input or a speed")(:)';
  inputs = k(k <= m.sizes.nv);
  speeds = m.sizes.nq + k(k > m.sizes.nv) - m.sizes.nv;
endfunction

## a closed state with the held coordinates where they are, if that can be had
function x = closed (m, x, held, t)
  held = held(held <= m.sizes.nq);
  try
    if (isempty (held))
      x = gsmbp_assemble (m, x, "time", t);
    else
      x = gsmbp_assemble (m, x, "time", t, "hold", m.states(held));
    endif
  end_try_catch
  x(m.sizes.nq + (1:m.sizes.nu)) = 0;
endfunction

function k = places (who, names, all_names, option, what)
  names = gs.given.asked_names (names)';
  k = gs.given.places_of (names, all_names);
  if (! all (k))
    error ("%s: option \"%s\": expected the name of %s, found %s", who, option, what,
           gs.text.nearest_word (names{find (! k, 1)}, all_names));
  endif
endfunction
