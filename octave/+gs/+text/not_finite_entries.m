## text = gs.text.not_finite_entries (J, rows, columns)
## What a message says of the derivatives J that are not finite: "" where all are, else the names of
## the first one's row and column.  ROWS, COLUMNS: their names, cell arrays.

function text = not_finite_entries (J, rows, columns)
  text = "";
  [i, j] = find (isinf (J), 1);   # a NaN may be one times 0
  if (isempty (i))
    [i, j] = find (isnan (J), 1);
  endif
  if (isempty (i))
    return;
  endif
  text = gs.text.refusal_text ("no_derivative", rows{i}, columns{j});
endfunction
