## yes = gsmbp_has_sundials (): whether there is what method "cvode" needs; for tests.

function yes = gsmbp_has_sundials ()
  cc = strtrim (mkoctfile ("-p", "CC"));
  yes = system (["echo '#include <cvode/cvode.h>' | " cc " -E - >/dev/null 2>&1"]) == 0;
endfunction
