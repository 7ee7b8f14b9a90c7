## gsmbp__need_derivatives (who, J, rows, columns)
## An error of WHO where a derivative in the matrix J is not finite; names of its rows and columns.

function gsmbp__need_derivatives (who, J, rows, columns)
  text = gsmbp__not_finite (J, rows, columns);
  if (! isempty (text))
    error ("gsmbp:derivative", "%s: %s", who, text);
  endif
endfunction
