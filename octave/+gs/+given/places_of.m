## k = gs.given.places_of (names, all_names)
## Where the names stand among all_names, 0 for one that is not there; motor_i means motor.i, too.

function k = places_of (names, all_names)
  [~, k] = ismember (names, all_names);
  [~, other] = ismember (strrep (names, ".", "_"), strrep (all_names, ".", "_"));
  k(k == 0) = other(k == 0);
endfunction
