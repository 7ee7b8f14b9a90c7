## [x, masses, slopes] = gs.model.made_values (m)
## What the scene makes of the parameters m.par by its routine INI: the initial state, the masses of
## the links [kg] in the order of m.json.masses, their derivatives by the parameters that each is
## made of, one mass after the other.

function [x, masses, slopes] = made_values (m)
  rows = gs.model.json_rows (m.json, "masses");
  slopes = sum (cellfun (@(row) numel (row.parameters), rows));
  [x, masses, slopes] = m.module ("ini", gs.model.parameter_values (m), ...
                                  [numel(rows), slopes]);
endfunction
