## gsmbp__sharp_friction (who, m, list, n)
## A warning of WHO for each port in LIST (gsmbp__sharp_ports) of N runs of the model M: events of
## its friction may be none.

function gsmbp__sharp_friction (who, m, list, n)
  while (! isempty (list))
    [one, own] = deal (list(1), [list.event] == list(1).event);
    where = "";
    if (n > 1)
      where = sprintf (" in run %d, the first of %d such runs of %d", one.run, nnz (own), n);
    endif
    list(own) = [];
    warning ("gsmbp:events", ["%s: %s: %s falls from its breakaway within vs = %.3g, the " ...
                              "tolerance of its speed (atol) is %.3g%s: %s may report events " ...
                              "that are none; expected atol below vs, and vs at least %.3g; " ...
                              "remedy: method \"auto\" or \"dp853\", or a larger vs"], ...
             who, m.name, m.events(one.event).name, one.vs, one.atol, where, one.method, ...
             one.least);
  endwhile
endfunction
