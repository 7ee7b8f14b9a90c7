## x = gs.model.initial_state (m)
## The start that the scene states for the parameters m.par: coordinates (a guess where
## there are loops), speeds zero, states of devices, of which those that the JSON calls
## settled (filters of sensors, observers) are where their rates vanish.

function x = initial_state (m)
  x = zeros (m.sizes.nx, 1);
  if (isfield (m.json, "initial") && numel (m.json.initial) == m.sizes.nx)
    x = double (m.json.initial(:));
  endif
  if (isfield (m.json, "starts") && any (strcmp (m.subroutines, "ini")))
    made = m.json.starts(:);
    value = gs.model.made_values (m);
    value = value(made);
    x(made(isfinite (value))) = value(isfinite (value));
  endif
  x = gs.start.settled_state (m, 0, x);
endfunction
