## list = gsmbp__filled (list, p, P)
## The arguments of a load case where functions of the values of the design have theirs.

function list = gsmbp__filled (list, p, P)
  for k = find (cellfun (@gsmbp__of_values, list))
    list{k} = list{k}(gsmbp__as_struct (P, p));
  endfor
endfunction
