## list = gs.model.scene_limits (m, names)
## The limits that the scene gives its coordinates or inputs NAMES, rows [least, largest] at the
## values of its parameters when it was derived; infinite where it gives none.

function list = scene_limits (m, names)
  list = repmat ([-Inf, Inf], numel (names), 1);
  for row = gs.model.json_rows (m.json, "limits")
    k = find (strcmp (names, row{1}.name));
    list(k,:) = repmat ([row{1}.low, row{1}.high], numel (k), 1);
  endfor
endfunction
