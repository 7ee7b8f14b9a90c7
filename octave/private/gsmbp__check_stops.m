## gsmbp__check_stops (who, m, t, x, modes)
## No port with a stop (variant event) of the model M may be beyond its ends at the start X, but one
## that MODES say is in contact: what it may be off by then the run time decides (GSRSM).

function gsmbp__check_stops (who, m, t, x, modes)
  stops = find (strcmp ({m.events.kind}, "stop"));
  if (isempty (stops))
    return;
  endif
  if (! isempty (modes))
    stops = stops(modes(stops) == 0);
  endif
  none = zeros (m.sizes.nv, 1);
  inside = m.evt (t, x, none, zeros (m.sizes.nmode, 1));
  k = stops(find (inside(stops) < -gsmbp__run_limit ("past_stop"), 1));
  if (! isempty (k))
    [~, place, ~, ends] = m.hld (t, x, none);
    error ("%s: %s: %s", who, m.name, ...
           gsmbp__refusal ("past_stop", m.events(k).name, ends(1:2,k), place(k)));
  endif
endfunction
