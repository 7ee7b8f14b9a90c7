## yes = gsmbp_has_ipopt (): whether there is what Ipopt needs; for tests.

function yes = gsmbp_has_ipopt ()
  cc = strtrim (mkoctfile ("-p", "CC"));
  yes = system (["echo '#include <coin/IpStdCInterface.h>' | " cc " -E - >/dev/null 2>&1"]) == 0;
endfunction
