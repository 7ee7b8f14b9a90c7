## list = gsmbp__event_list (m, record)
## The events of a run from their record (a column each, see the module): a
## struct with rows t, number, name, device (the same), mode (after it), loss (of mechanical
## energy [J]), before and after (states).

function list = gsmbp__event_list (m, record)
  nx = m.sizes.nx;
  all = (rows (record) - 3) / 2;   # with the two states of an audit or without
  n = columns (record);
  list = struct ("t", record(1,:)', "number", record(2,:)', "name", {cell(n, 1)}, "device", ...
                 {cell(n, 1)}, "mode", record(3,:)', "loss", zeros (n, 1), ...
                 "before", record(3 + (1:nx),:)', "after", record(3 + all + (1:nx),:)');
  for k = 1:n
    list.name{k} = list.device{k} = m.events(list.number(k)).name;
    if (any (strcmp (m.subroutines, "ene")) && ! isequal (list.before(k,:), list.after(k,:)))
      energy = @(x) sum (m.ene (list.t(k), x')(1:3));
      list.loss(k) = energy (list.before(k,:)) - energy (list.after(k,:));
    endif
  endfor
endfunction
