## list = gs.events.event_list (m, record)
## The events of a run from their record (a column each, see the module): a
## struct with rows t, number, name, device (the same), mode (after it), loss (of mechanical
## energy [J]), before and after (states).

function list = event_list (m, record)
  nx = m.sizes.nx;
  all = (rows (record) - 3) / 2;   # with the two states of an audit or without
  n = columns (record);
  names = {m.events.name}(record(2,:))(:);
  list = struct ("t", record(1,:)', "number", record(2,:)', "name", {names}, "device", {names}, ...
                 "mode", record(3,:)', "loss", zeros (n, 1), "before", ...
                 record(3 + (1:nx),:)', "after", record(3 + all + (1:nx),:)');
  hits = find (any (list.before != list.after, 2));
  if (any (strcmp (m.subroutines, "ene")) && ! isempty (hits))
    energy = @(x) gs.run.energy_sums (m, list.t(hits), x(hits,:), []);
    lost = energy (list.before) - energy (list.after);
    list.loss(hits) = sum (lost(:,1:3), 2);
  endif
endfunction
