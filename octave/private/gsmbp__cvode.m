## library = gsmbp__cvode (who, m)
## The shared library of glue/gsmbp_cvode.c for the module of the model M, built
## where it is missing or old: only who asks for CVODE needs SUNDIALS.

function library = gsmbp__cvode (who, m)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  common = fullfile (fileparts (fileparts (m.file)), "common");
  library = fullfile (common, "libgsmbp_cvode.so");
  if (! gsmbp__older (library, {fullfile(common, "flags")}))
    return;
  endif
  cc = strtrim (mkoctfile ("-p", "CC"));
  if (system (["echo '#include <cvode/cvode.h>' | " cc " -E - >/dev/null 2>&1"]) != 0)
    error (["%s: method \"cvode\" needs SUNDIALS, which is not installed (Debian: " ...
            "libsundials-dev)"], who);
  endif
  new = sprintf ("%s.%d", library, getpid ());
  unwind_protect
    gsmbp__run (who, sprintf (["%s -std=gnu11 -O2 -march=native -fPIC -shared -I%s -o %s %s " ...
                               "-lsundials_cvode -lsundials_nvecserial " ...
                               "-lsundials_sunmatrixdense -lsundials_sunlinsoldense -lm"],
                              cc, quote (gsmbp__place ("share", "c")), quote (new), ...
                              quote (gsmbp__place ("octave", "glue", "gsmbp_cvode.c"))));
    gsmbp__put_in_place (who, new, library);
  unwind_protect_cleanup
    [~, ~] = unlink (new);   # there only if the command failed
  end_unwind_protect
endfunction
