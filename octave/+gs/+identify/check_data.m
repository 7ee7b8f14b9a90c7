## gs.identify.check_data (who, m, name, x, nt)
## An error of WHO unless X, the field NAME of measured data, has NT rows of finite numbers, a
## column for each coordinate of M.

function check_data (who, m, name, x, nt)
  if (! (isnumeric (x) && isreal (x) && isequal (size (x), [nt, m.sizes.nu])))
    error ("%s: data.%s: expected %d x %d finite numbers, found %s", who, name, nt, ...
           m.sizes.nu, gs.text.shown_value (x));
  endif
  gs.given.check_table (who, ["data." name], x, m.coordinates(:)');
endfunction
