## p = gsmbp__moved (p, k, value)
## The column P with its K-th number replaced.

function p = gsmbp__moved (p, k, value)
  p(k) = value;
endfunction
