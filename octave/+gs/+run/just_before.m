## t = gs.run.just_before (t)
## Times just before the times T, as GSLFT has them.

function t = just_before (t)
  t -= max (2 * eps * abs (t), 1e-300);
endfunction
