## yes = gs.events.may_end (m)
## May an event of the scene end a run of the model M?

function yes = may_end (m)
  yes = ! isempty (m.events) && isfield (m.events, "ends") && any ([m.events.ends]);
endfunction
