## ip = gsmbp__event_plan (who, m, o, ip)
## The plan of the events (share/fortran/events/gsres.f) behind the array IP of gsinp.f,
## where the scene M has events.  O: the options of gsmbp_simulate.

function ip = gsmbp__event_plan (who, m, o, ip)
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
  if (! any (strcmp (o.method, {"dp853", "rk4"})))
    error ("%s: %s has events (%s): method must be \"dp853\" or \"rk4\"", who, m.name, ...
           m.events(1).name);
  endif
  if (! (isnumeric (o.modes) && any (numel (o.modes) == [0, n]) ...
           && all (any (o.modes(:) == [-1, 0, 1], 2))))
    error ("%s: option modes: expected %d numbers, each -1, 0 or 1", who, n);
  endif
  modes = zeros (1, n);
  modes(1:numel (o.modes)) = o.modes;
  kinds = 1 + strcmp ({m.events.kind}, "stop");
  ip(28) = numel (ip) + 1;
  ip = [ip, n, 10000, 0, 0, ! isempty(o.modes), zeros(1, 5), modes, [m.events.input], kinds, ...
        zeros(1, 3 * n)];
endfunction
