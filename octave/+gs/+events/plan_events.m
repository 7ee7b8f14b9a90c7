## plan = gs.events.plan_events (who, m, o, plan)
## The plan of a run with its events, where the scene M has such.  O: the options of gsmbp_simulate.

function plan = plan_events (who, m, o, plan)
  n = numel (m.events);
  if (n == 0)
    if (! isempty (o.modes))
      error ("%s: option modes: %s has no events", who, m.name);
    endif
    return;
  endif
  if (! any (strcmp (m.subroutines, "evt")))
    error (["%s: %s has events, but was emitted without the subroutines EVT, RST " ...
            "(request events)"], who, m.name);
  endif
  if (! (isnumeric (o.modes) && any (numel (o.modes) == [0, n]) ...
           && all (any (o.modes(:) == [-1, 0, 1], 2))))
    error ("%s: option modes: expected %d numbers, each -1, 0 or 1, found %s", who, n, ...
           gs.text.shown_value (o.modes));
  endif
  gs.given.refuse_given_modes (who, m, plan.constants, o.modes);
  plan.modes = double (o.modes(:)');
  plan.events = gs.text.run_limit ("recorded_events");
  plan.event_inputs = [m.events.input];
  plan.event_kinds = 1 + strcmp ({m.events.kind}, "stop");
  plan = user_events (m, plan);
endfunction

## kinds of the events of the user; the inputs that they switch; which events change what follows
function plan = user_events (m, plan)
  plan.switch_events = plan.switch_inputs = [];
  plan.event_changes = double (gs.events.changing_events (m));
  if (! isfield (m.events, "ends"))
    return;
  endif
  own = strcmp ({m.events.kind}, "event");
  plan.event_kinds(own) = 3 + [m.events(own).ends];
  plan.event_kinds(own & plan.event_kinds == 3 & ! plan.event_changes) = 5;
  for k = find (own)
    plan.switch_inputs = [plan.switch_inputs, m.events(k).switches(:)'];
    plan.switch_events(end+1:numel (plan.switch_inputs)) = k;
  endfor
endfunction
