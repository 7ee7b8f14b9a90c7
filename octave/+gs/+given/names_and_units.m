## [names, units] = gs.given.names_and_units (list)
## Column cell arrays of the names and units of a list as jsondecode leaves it:
## a struct array with name and unit, a cell array of such, or strings.

function [names, units] = names_and_units (list)
  names = units = cell (0, 1);
  if (isempty (list))
    return;
  endif
  if (ischar (list))
    list = {list};
  endif
  for i = 1:numel (list)
    if (iscell (list))
      entry = list{i};
    else
      entry = list(i);
    endif
    if (ischar (entry))
      entry = struct ("name", entry, "unit", "");
    elseif (! isfield (entry, "unit"))
      entry.unit = "";
    endif
    names{i,1} = entry.name;
    units{i,1} = entry.unit;
  endfor
endfunction
