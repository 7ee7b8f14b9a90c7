## m = gs.optimize.design_model (P, p)
## The model of a design with the values P of its free variables.

function m = design_model (P, p)
  m = P.base;
  k = strcmp ({P.free.kind}, "parameter");
  if (any (k))
    m = gsmbp_set (m, cell2struct (num2cell (p(k)(:)), {P.free(k).name}(:), 1));
  endif
endfunction
