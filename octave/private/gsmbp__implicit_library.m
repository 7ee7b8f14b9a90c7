## library = gsmbp__implicit_library (who, m, method)
## The shared library of an implicit METHOD, "cvode" or "radau" (glue/implicit.c and
## glue/gsmbp_METHOD.c), for the module of the model M, built where it is missing or old: only who
## asks for CVODE needs SUNDIALS.

function library = gsmbp__implicit_library (who, m, method)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  common = fullfile (fileparts (fileparts (m.file)), "common");
  library = fullfile (common, ["libgsmbp_" method ".so"]);
  if (! gsmbp__older (library, {fullfile(common, "flags")}))
    return;
  endif
  cc = strtrim (mkoctfile ("-p", "CC"));
  cvode = strcmp (method, "cvode");
  if (cvode && system (["echo '#include <cvode/cvode.h>' | " cc " -E - >/dev/null 2>&1"]) != 0)
    error (["%s: method \"cvode\" needs SUNDIALS, which is not installed (Debian: " ...
            "libsundials-dev)"], who);
  endif
  parts = {"implicit.c", ["gsmbp_" method ".c"], "radau_rule.c", "radau_solve.c"};
  links = "-lm";
  if (cvode)
    parts = parts(1:2);
    links = ["-lsundials_cvode -lsundials_nvecserial -lsundials_sunmatrixdense " ...
             "-lsundials_sunlinsoldense -lm"];
  endif
  sources = cellfun (@(f) quote (gsmbp__place ("octave", "glue", f)), parts, ...
                     "uniformoutput", false);
  new = sprintf ("%s.%d", library, getpid ());
  unwind_protect
    gsmbp__run (who, sprintf (["%s -std=gnu11 -O2 -march=native -fcx-limited-range -fPIC " ...
                               "-shared -I%s -o %s %s %s"], cc, ...
                              quote (gsmbp__place ("share", "c")), quote (new), ...
                              strjoin (sources, " "), links));
    gsmbp__put_in_place (who, new, library);
  unwind_protect_cleanup
    [~, ~] = unlink (new);   # there only if the command failed
  end_unwind_protect
endfunction
