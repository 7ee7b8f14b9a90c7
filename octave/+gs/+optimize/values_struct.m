## s = gs.optimize.values_struct (P, p)
## The values P of the free variables of a design as a struct by their names, with what was
## chosen from lists; names with a dot (of states of devices) with _ in its place.

function s = values_struct (P, p)
  names = strrep ({P.free.name}, ".", "_");
  s = P.given;
  for k = 1:numel (names)
    s.(names{k}) = p(k);
  endfor
endfunction
