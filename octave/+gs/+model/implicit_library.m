## library = gs.model.implicit_library (who, m, method)
## The shared library of an implicit METHOD for the module of the model M: "cvode" has one
## (share/engine/host/cvode), built where it is missing or old, as only who asks for CVODE needs
## SUNDIALS; the others are part of the module, and LIBRARY is METHOD.

function library = implicit_library (who, m, method)
  library = method;
  row = gs.run.method_row (method);
  if (! strcmp (row.by, "library"))
    return;
  endif
  common = fullfile (fileparts (fileparts (m.file)), "common");
  library = fullfile (common, "libgsmbp_cvode.so");
  persistent looked_at = {};   # its texts, by this session: it is in use from then on
  if (any (strcmp (looked_at, library)) && ! isempty (stat (library)))
    return;
  endif
  part = gs.model.runtime_archive ("double");
  [~, ~, flags] = gs.model.fortran_flags ("double");
  cc = [strtrim(mkoctfile ("-p", "CC")) " " flags " -shared"];
  source = gs.files.own_place ("share", "engine", "host", "cvode", "cvode.c");
  archive = fullfile (common, part{1});
  gs.files.build_once (who, library, cc, [{source; archive}; glob(regexprep (source, ...
      'cvode\.c$', "*.h"))
                                  part{3}(! cellfun (@isempty, regexp (part{3}, '\.h$')))], ...
                @(place) compile (who, cc, source, archive, place));   # not kept: which SUNDIALS
  looked_at{end+1} = library;                                          # there is is not in a key
endfunction

function new = compile (who, cc, source, archive, place)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  new = "library.so";
  [words, found] = gs.files.find_header ("cvode");
  if (! found)
    error ("%s: %s", who, gs.text.refusal_text ("no_sundials"));
  endif
  gs.files.run_command (who, sprintf (["%s -I%s -I%s -o %s %s %s -lsundials_cvode " ...
                             "-lsundials_nvecserial " ...
                             "-lsundials_sunmatrixdense -lsundials_sunlinsoldense -lm %s"], ...
                            cc, quote (gs.files.own_place ("share", "engine", "core")), ...
                            quote (gs.files.own_place ("share", "engine")), ...
                            quote (fullfile (place, new)), quote (source), quote (archive), words));
endfunction
