## x = gsmbp__settle (m, t, x)
## The state X of the model M with the states that the JSON calls settled where their
## rates vanish at the time T [s] and with all inputs zero, the others as they are (host/start.h).

function x = gsmbp__settle (m, t, x)
  x = m.module ("settle", m.cst, gsmbp__par (m), t, x, m.nominal);
endfunction
