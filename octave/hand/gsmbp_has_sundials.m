## yes = gsmbp_has_sundials (): whether there is what method "cvode" needs; for tests.

function yes = gsmbp_has_sundials ()
  glue = fullfile (fileparts (which ("gsmbp_build")), "glue");
  yes = system (sprintf ("sh '%s/find_header' '%s/header_cvode.h' %s >/dev/null", glue, glue, ...
                         strtrim (mkoctfile ("-p", "CC")))) == 0;
endfunction
