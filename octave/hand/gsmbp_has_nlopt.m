## yes = gsmbp_has_nlopt (): whether there is what NLopt needs; for tests.

function yes = gsmbp_has_nlopt ()
  yes = gsmbp_has_header ("engine/host/nlopt/header_nlopt.h");
endfunction
