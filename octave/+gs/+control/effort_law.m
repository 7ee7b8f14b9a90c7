## c = gs.control.effort_law (who, m, o, law)
## A controller of gsmbp_model_control for an open chain M with an ideal effort on each speed: what
## it drives, and the efforts that hold it where it starts.

function c = effort_law (who, m, o, law)
  n = m.sizes.nu;
  c = struct ("method", law, "name", o.name, "period", o.period, "delay", o.delay);
  c.driven = gs.given.asked_names (o.inputs);
  if (isempty (c.driven))
    c.driven = m.inputs;
  endif
  x = m.initial;
  if (! isempty (o.trim))
    x = gs.given.given_vector (who, "option trim", o.trim.x, m.sizes.nx, "", m.states);
  endif
  c.u0 = m.inv (0, x(1:n), x(n + (1:n)), zeros (n, 1), zeros (m.sizes.nv, 1))(:);
  c.A = eye (n);
endfunction
