## sets = gs.model.orientation_sets (json)
## The numbers of the coordinates that are Euler parameters, a row of four for each set.

function sets = orientation_sets (json)
  sets = zeros (0, 4);
  if (isfield (json, "orientation") && ! isempty (json.orientation))
    list = json.orientation;
    if (iscell (list))
      list = cell2mat (cellfun (@(row) row(:)', list, "UniformOutput", false));
    endif
    sets = reshape (double (list'), 4, [])';
  endif
endfunction
