## p = gs.optimize.replace_value (p, k, value)
## The column P with its K-th number replaced.

function p = replace_value (p, k, value)
  p(k) = value;
endfunction
