## groups = gsmbp__event_groups (m)
## Of each event of the model M the number of the first one with its name: an event in both
## directions is two.

function groups = gsmbp__event_groups (m)
  names = {m.events.name};
  groups = cellfun (@(name) find (strcmp (names, name), 1), names);
endfunction
