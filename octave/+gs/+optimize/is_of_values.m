## yes = gs.optimize.is_of_values (x)
## Whether X is a function of one argument, the values of a design by their names.

function yes = is_of_values (x)
  yes = is_function_handle (x) && nargin (x) == 1;
endfunction
