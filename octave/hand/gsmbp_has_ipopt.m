## yes = gsmbp_has_ipopt (): whether there is what Ipopt needs; for tests.

function yes = gsmbp_has_ipopt ()
  yes = gsmbp_has_header ("engine/host/ipopt/header_ipopt.h");
endfunction
