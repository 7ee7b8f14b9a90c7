## t = gsmbp__just_before (t)
## Times just before the times T, as GSLFT has them.

function t = gsmbp__just_before (t)
  t -= max (2 * eps * abs (t), 1e-300);
endfunction
