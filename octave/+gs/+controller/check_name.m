## gs.controller.check_name (who, c)
## An error of WHO where the name of the controller C is none of Fortran and C.

function check_name (who, c)
  if (isempty (regexp (c.name, '^[A-Za-z][A-Za-z0-9_]{0,29}$', "once")))
    error (["%s: the controller %s: expected a name of letters, digits and _ that begins with " ...
            "a letter, at most 30"], who, c.name);
  endif
endfunction
