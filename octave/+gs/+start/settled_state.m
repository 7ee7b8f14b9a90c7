## x = gs.start.settled_state (m, t, x)
## The state X of the model M with the states that the JSON calls settled where their
## rates vanish at the time T [s] and with all inputs zero, the others as they are (host/start.h).

function x = settled_state (m, t, x)
  x = m.module ("settle", m.cst, gs.model.parameter_values (m), t, x, m.nominal);
endfunction
