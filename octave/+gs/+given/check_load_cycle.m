## gs.given.check_load_cycle (who, c)
## An error of WHO unless C is a load cycle of gsmbp_cycle.

function check_load_cycle (who, c)
  fields = {"t", "position", "omega", "alpha", "torque", "inertia", "unit"};
  if (! (isstruct (c) && isscalar (c) && all (isfield (c, fields))))
    error ("%s: argument cycle: expected a struct of gsmbp_cycle, found %s", who, ...
           gs.text.shown_value (c));
  endif
  for name = {"t", "omega", "alpha", "torque"}
    x = c.(name{1});
    if (! (isnumeric (x) && isreal (x) && isequal (size (x), size (c.t)) && columns (x) == 1 ...
           && rows (x) > 1 && all (isfinite (x))))
      error (["%s: argument cycle: %s: expected a column of finite numbers, one for each of " ...
              "two or more times, found %s"], who, name{1}, gs.text.shown_value (x));
    endif
  endfor
endfunction
