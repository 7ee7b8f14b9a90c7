## yes = gsmbp_has_sundials (): whether there is what method "cvode" needs; for tests.

function yes = gsmbp_has_sundials ()
  yes = gsmbp_has_header (fullfile ("engine", "host", "cvode", "header_cvode.h"));
endfunction
