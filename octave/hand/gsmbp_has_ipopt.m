## yes = gsmbp_has_ipopt (): whether there is what Ipopt needs; for tests.

function yes = gsmbp_has_ipopt ()
  yes = gsmbp_has_header (fullfile (fileparts (which ("gsmbp_build")), "glue", "header_ipopt.h"));
endfunction
