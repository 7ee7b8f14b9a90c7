## list = gs.optimize.fill_arguments (list, p, P)
## The arguments of a load case where functions of the values of the design have theirs.

function list = fill_arguments (list, p, P)
  for k = find (cellfun (@gs.optimize.is_of_values, list))
    list{k} = list{k}(gs.optimize.values_struct (P, p));
  endfor
endfunction
