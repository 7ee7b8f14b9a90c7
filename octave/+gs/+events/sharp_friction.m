## gs.events.sharp_friction (who, m, list, n)
## A warning of WHO for each port in LIST (gs.events.sharp_ports) of N runs of the model M: events
## of its friction may be none.

function sharp_friction (who, m, list, n)
  while (! isempty (list))
    [one, own] = deal (list(1), [list.event] == list(1).event);
    where = "";
    if (n > 1)
      where = sprintf (" in run %d, the first of %d such runs of %d", one.run, nnz (own), n);
    endif
    list(own) = [];
    warning ("gsmbp:events", "%s: %s: %s", who, m.name, ...
             gs.text.refusal_text ("sharp_friction", m.events(one.event).name, one.vs, one.atol, ...
                                   where, one.method, one.least));
  endwhile
endfunction
