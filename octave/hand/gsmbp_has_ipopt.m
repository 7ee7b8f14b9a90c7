## yes = gsmbp_has_ipopt (): whether there is what Ipopt needs; for tests.

function yes = gsmbp_has_ipopt ()
  glue = fullfile (fileparts (which ("gsmbp_build")), "glue");
  yes = system (sprintf ("sh '%s/find_header' '%s/header_ipopt.h' %s >/dev/null", glue, glue, ...
                         strtrim (mkoctfile ("-p", "CC")))) == 0;
endfunction
