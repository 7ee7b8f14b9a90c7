## text = gs.events.wrong_mode (m, t, x, modes, k)
## Why the mode of event K of the model M, of those that are given, contradicts the state X at T
## (host/start.h).

function text = wrong_mode (m, t, x, modes, k)
  text = ["option modes: ", m.module("wrong mode", m.cst, gs.model.parameter_values (m), t, x, ...
                                     m.nominal, double (modes), k)];
endfunction
