## library = gsmbp__implicit_library (who, m, method)
## The shared library of an implicit METHOD, "cvode", "radau" or "gauss" (glue/implicit*.c and
## glue/gsmbp_METHOD.c), for the module of the model M, built where it is missing or old: only who
## asks for CVODE needs SUNDIALS.

function library = gsmbp__implicit_library (who, m, method)
  common = fullfile (fileparts (fileparts (m.file)), "common");
  library = fullfile (common, ["libgsmbp_" method ".so"]);
  persistent looked_at = {};   # its texts, by this session: it is in use from then on
  if (any (strcmp (looked_at, library)) && ! isempty (stat (library)))
    return;
  endif
  parts = {"implicit.c", "implicit_rates.c", "implicit_events.c", "implicit_look.c", ...
           ["gsmbp_" method ".c"]};
  links = "-lm";
  if (strcmp (method, "radau"))
    parts = [parts, {"radau_rule.c", "radau_order.c", "radau_solve.c", "settle.c", ...
                     "radau_index2.c"}];
  elseif (strcmp (method, "gauss"))
    parts = [parts, {"gauss_rule.c", "gauss_momenta.c"}];
  elseif (strcmp (method, "cvode"))
    parts = [parts, {"settle.c", "radau_solve.c"}];
    links = ["-lsundials_cvode -lsundials_nvecserial -lsundials_sunmatrixdense " ...
             "-lsundials_sunlinsoldense -lm"];
  endif
  cc = strtrim (mkoctfile ("-p", "CC"));
  glue = @(f) gsmbp__place ("octave", "glue", f);
  sources = cellfun (glue, parts(:), "UniformOutput", false);
  cc = [cc " -std=gnu11 -O2" gsmbp__processor() " -fcx-limited-range -fPIC -shared"];
  kept = {cc};
  if (strcmp (method, "cvode"))   # which SUNDIALS there is is not in the key
    kept = {};
  endif
  gsmbp__built (who, library, [cc " " links], ...
                [sources; glob(glue ("*.h")); ...
                 glob(gsmbp__place ("share", "c", "gsmbp", "*.h"))], ...
                @(place) compile (who, cc, sources, links, place), kept{:});
  looked_at{end+1} = library;
endfunction

function new = compile (who, cc, sources, links, place)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  new = "library.so";
  words = "";
  if (any (strfind (links, "cvode")))
    [words, found] = gsmbp__find_header ("cvode");
    if (! found)
      error (["%s: method \"cvode\" needs SUNDIALS 6 or 7, which is not installed (Debian: " ...
              "libsundials-dev)"], who);
    endif
  endif
  gsmbp__run (who, sprintf ("%s -I%s -o %s %s %s", cc, ...
                            quote (gsmbp__place ("share", "c")), ...
                            quote (fullfile (place, new)), ...
                            strjoin (cellfun (quote, sources', "UniformOutput", false), " "), ...
                            [links " " words]));
endfunction
