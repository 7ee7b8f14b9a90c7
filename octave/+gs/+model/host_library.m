## library = gs.model.host_library (who, m, name)
## The shared library NAME, "cvode", "ipopt" or "nlopt", of share/engine/host for the modules of the
## model M, built where it is missing or old: only who asks for it needs SUNDIALS, Ipopt or NLopt.

function library = host_library (who, m, name)
  common = fullfile (fileparts (fileparts (m.file)), "common");
  library = fullfile (common, ["libgsmbp_" name ".so"]);
  persistent looked_at = {};   # its texts, by this session: it is in use from then on
  if (any (strcmp (looked_at, library)) && ! isempty (stat (library)))
    return;
  endif
  part = gs.model.runtime_archive ("double");
  [~, ~, flags] = gs.model.fortran_flags ("double");
  cc = [strtrim(mkoctfile ("-p", "CC")) " " flags " -shared"];
  folder = gs.files.own_place ("share", "engine", "host", name);
  sources = {fullfile(folder, [name ".c"])};
  if (strcmp (name, "cvode"))
    sources{2} = fullfile (common, part{1});
  else
    sources{2} = gs.files.own_place ("share", "engine", "host", "collocation", "wall_clock.c");
  endif
  gs.files.build_once (who, library, cc, [sources(:); glob(fullfile (folder, "*.h"))
                                  part{3}(! cellfun (@isempty, regexp (part{3}, '\.h$')))], ...
                @(place) compile (who, cc, name, sources, place));   # not kept: which of them there
  looked_at{end+1} = library;                                        # is is not in a key
endfunction

function new = compile (who, cc, name, sources, place)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  new = "library.so";
  [words, found] = gs.files.find_header (name);
  others = {"cvode", "no_sundials", ["-lsundials_cvode -lsundials_nvecserial " ...
                                     "-lsundials_sunmatrixdense -lsundials_sunlinsoldense -lm"]
            "ipopt", "no_ipopt", "-lipopt -lm"
            "nlopt", "no_nlopt", "-lnlopt -lm"};
  [refusal, libraries] = others{strcmp (others(:,1), name),2:3};
  if (! found)
    error ("%s: %s", who, gs.text.refusal_text (refusal));
  endif
  gs.files.run_command (who, sprintf ("%s -I%s -I%s -o %s %s %s %s %s", cc, ...
                            quote (gs.files.own_place ("share", "engine", "core")), ...
                            quote (gs.files.own_place ("share", "engine")), ...
                            quote (fullfile (place, new)), quote (sources{1}), ...
                            quote (sources{2}), libraries, words));
endfunction
