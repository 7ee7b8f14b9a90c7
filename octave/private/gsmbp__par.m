## par = gsmbp__par (m)
## The values of the parameters of the model M as its module takes them.

function par = gsmbp__par (m)
  par = cellfun (@double, struct2cell (m.par));
endfunction
