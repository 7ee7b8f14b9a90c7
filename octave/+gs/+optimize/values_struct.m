## s = gs.optimize.values_struct (P, p)
## The values P of the free variables of a design as a struct by their names; names with a dot (of
## states of devices) with _ in its place.

function s = values_struct (P, p)
  names = strrep ({P.free.name}, ".", "_");
  s = cell2struct (num2cell (p(:)), names(:), 1);
endfunction
