## rows = gs.model.json_rows (json, name)
## The list NAME of the JSON as a row of cells, one struct each; empty where there is none.

function rows = json_rows (json, name)
  rows = cell (1, 0);
  if (isfield (json, name) && ! isempty (json.(name)))
    rows = json.(name);
    if (! iscell (rows))
      rows = num2cell (rows);
    endif
    rows = rows(:)';
  endif
endfunction
