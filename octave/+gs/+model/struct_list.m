## list = gs.model.struct_list (l)
## What jsondecode made of a list of objects: a row of structs.

function list = struct_list (l)
  list = struct ([]);
  if (iscell (l) && ! isempty (l))
    list = [l{:}];
  elseif (isstruct (l))
    list = l(:)';
  endif
endfunction
