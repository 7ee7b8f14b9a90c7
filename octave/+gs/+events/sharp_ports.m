## list = gs.events.sharp_ports (m, r)
## Ports with events of the model M whose friction falls, in the run R, from its breakaway within a
## speed vs that the method of the run cannot resolve: above it a fast mode grows, which an implicit
## step damps where the tolerance lets it.  By counts of events (a block on a spring, radau and
## cvode, vs and atol from 1e-3 to 1e-12) that is where atol of the speed is vs or more, or vs is
## below 5e-9 of the nominal speed.
##
## R: its number run, method, atol (of the states), happened (numbers of the events that did), and
## t, x, v of one instant.  LIST: a struct array with run, method, event (the number of the port),
## vs, atol and least (the smallest vs by the nominal speed).

function list = sharp_ports (m, r)
  list = struct ("run", {}, "method", {}, "event", {}, "vs", {}, "atol", {}, "least", {});
  happened = {m.events(r.happened).name};
  ports = find (strcmp ({m.events.kind}, "stick") & ismember ({m.events.name}, happened));
  if (isempty (ports) || ! any (strcmp (r.method, {"radau", "cvode"})))
    return;
  endif
  [rows, ~, ~, held] = m.hld (r.t, r.x(:), r.v(:));
  speeds = m.sizes.nq + (1:m.sizes.nu);
  for k = ports
    row = abs (rows(k,:));
    [vs, atol, least] = deal (held(2,k), row * r.atol(speeds)(:), ...
                              5e-9 * row * m.nominal(speeds)(:));
    if (vs > 0 && (vs <= atol || vs < least))
      list(end+1) = struct ("run", r.run, "method", r.method, "event", k, "vs", vs, "atol", ...
                            atol, "least", least);
    endif
  endfor
endfunction
