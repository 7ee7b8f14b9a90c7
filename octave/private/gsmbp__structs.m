## list = gsmbp__structs (l)
## What jsondecode made of a list of objects: a row of structs.

function list = gsmbp__structs (l)
  list = struct ([]);
  if (iscell (l) && ! isempty (l))
    list = [l{:}];
  elseif (isstruct (l))
    list = l(:)';
  endif
endfunction
