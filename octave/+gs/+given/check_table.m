## gs.given.check_table (who, what, x, heads)
## An error of WHO that names the first row of the matrix X with a number that is not finite, and
## its column, with its head where HEADS are given.  WHAT: how messages call X.

function check_table (who, what, x, heads = {})
  row = find (! all (isfinite (x), 2), 1);
  if (isempty (row))
    return;
  endif
  column = find (! isfinite (x(row,:)), 1);
  head = "";
  if (! isempty (heads))
    head = sprintf (" (%s)", heads{column});
  endif
  error ("%s: %s: expected finite numbers, found %g in row %d, column %d%s", who, what, ...
         x(row,column), row, column, head);
endfunction
