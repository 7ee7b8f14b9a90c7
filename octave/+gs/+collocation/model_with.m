## m = gs.collocation.model_with (m, c, values)
## The model M with the VALUES of the free parameters of a program C.

function m = model_with (m, c, values)
  held = cellfun (@(name) m.par.(name), c.parameters);
  if (any (values(:) != held(:)))
    m = gsmbp_set (m, [c.parameters(:)'; num2cell(values(:)')](:){:});
  endif
endfunction
