## at = gs.run.switch_times (m): the times at which the scene of a model switches [s], a row.

function at = switch_times (m)
  at = zeros (1, 0);
  if (any (strcmp (m.subroutines, "swi")))
    at = m.swi ()';
  endif
endfunction
