## p = gs.run.plan_run (who, m, x0, times, o)
## A run of the model M from X0 at TIMES(1) by the options O of gsmbp_simulate: a struct with M, O,
## TIMES, CARRIED (gs.linear.carried_columns) and GIVEN, what the module takes of a run
## (glue/asked_run.h), which says what is wrong with it (gs.run.refuse_run).

function p = plan_run (who, m, x0, times, o)
  d = m.sizes;
  p = struct ("m", m, "o", o, "times", gs.given.given_times (who, times));
  if (numel (p.times) < 2)
    error ("%s: %s", who, gs.text.refusal_text ("one_time", sprintf ("%.15g alone", p.times)));
  endif
  x0 = gs.given.given_vector (who, "x0", x0, d.nx, sprintf (" (the states of %s)", m.name), ...
                              m.states);
  p.carried = gs.linear.carried_columns (who, m, o);
  run = gs.run.engine_options (who, m, o);
  run.times = p.times;
  run.x0 = x0;
  run.par = gs.model.parameter_values (m);
  run.nominal = m.nominal;
  run.modes = gs.events.given_modes (who, m, o.modes);
  run.changes = double (gs.events.changing_events (m));
  run.memory = gs.run.given_memory (who, m, o.memory);
  for part = {p.carried, gs.run.engine_inputs(who, m, o, p.times(1), x0)}
    for name = fieldnames (part{1})'
      run.(name{1}) = part{1}.(name{1});
    endfor
  endfor
  p.given = run;
endfunction
