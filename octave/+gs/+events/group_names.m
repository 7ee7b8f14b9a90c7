## groups = gs.events.group_names (m)
## Of each event of the model M the number of the first one with its name: an event in both
## directions is two.

function groups = group_names (m)
  names = {m.events.name};
  groups = cellfun (@(name) find (strcmp (names, name), 1), names);
endfunction
