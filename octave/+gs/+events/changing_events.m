## is = gs.events.changing_events (m)
## Which events of the model M change states, inputs or modes: all but those of the user that only
## report or stop.

function is = changing_events (m)
  is = true (1, numel (m.events));
  if (! isfield (m.events, "resets"))
    return;
  endif
  own = strcmp ({m.events.kind}, "event");
  is(own) = arrayfun (@(e) numel (e.resets) + numel (e.switches) > 0, m.events(own));
endfunction
