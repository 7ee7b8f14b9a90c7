## rank = gs.start.general_rank (m)
## How many constraints of the model M are independent where its loops are closed near the start of
## the scene, 0 where the scene does not say it.

function rank = general_rank (m)
  rank = 0;
  if (isfield (m, "mobility") && isfield (m.mobility, "rank"))
    rank = m.mobility.rank;
  endif
endfunction
