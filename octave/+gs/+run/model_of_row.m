## m = gs.run.model_of_row (m, rows, i)
## The model M with the parameters of run I of ROWS (gs.run.many_runs), and those of its handles
## that reasons and warnings of runs need: they may be many.

function m = model_of_row (m, rows, i)
  if (isempty (rows.table))
    return;
  endif
  names = fieldnames (m.par)(rows.which);
  for k = 1:numel (names)
    m.par.(names{k}) = rows.table(i,k);
  endfor
  m = gs.model.model_handles (m, {"rhs", "con", "prj", "mar", "hld", "evt"});
endfunction
