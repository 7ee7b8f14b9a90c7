## t = gs.run.row_times (m, t)
## The times that stand for the rows T of a run of the model M: where the scene switches the row has
## what was before, as the inputs in it, but for the first one.

function t = row_times (m, t)
  at = gs.run.switch_times (m);
  if (isempty (at) || isempty (t))
    return;
  endif
  left = ismember (t, at);
  left(1) = false;
  t(left) = gs.run.just_before (t(left));
endfunction
