## y = gs.run.output_values (m, t, x, v)
## The outputs of the scene along a result, a row for each time; NaN where they are not emitted or
## cannot be calculated.

function y = output_values (m, t, x, v)
  y = NaN (numel (t), m.sizes.ny);
  if (m.sizes.ny > 0 && any (strcmp (m.subroutines, "out")))
    y = m.module ("outputs", m.cst, numel (t), t(:), x, v)';
  endif
endfunction
