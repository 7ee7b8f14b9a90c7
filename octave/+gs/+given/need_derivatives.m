## gs.given.need_derivatives (who, J, rows, columns)
## An error of WHO where a derivative in the matrix J is not finite; names of its rows and columns.

function need_derivatives (who, J, rows, columns)
  text = gs.text.not_finite_entries (J, rows, columns);
  if (! isempty (text))
    error ("gsmbp:derivative", "%s: %s", who, text);
  endif
endfunction
