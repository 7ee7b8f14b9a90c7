## call = gs.sweep.file_functions (who, m)
## The functions of chunks and tables on disk (glue/gsmbp_sweep_files.cc) as one handle, built
## beside the module of the model M where they are missing or old.

function call = file_functions (who, m)
  persistent loaded = "";
  folder = fullfile (fileparts (fileparts (m.file)), "common");
  file = fullfile (folder, "gsmbp_sweep_files.oct");
  parts = {"sweep_files.c", "sweep_place.c", "sweep_table.c", "gsmbp_sweep_files.cc", ...
           "sweep_files.h"};
  sources = cellfun (@(f) gs.files.own_place ("octave", "glue", f), parts, "UniformOutput", false);
  gs.files.build_once (who, file, OCTAVE_VERSION (), sources, ...
                       @(place) compile (who, sources, place));
  if (! strcmp (loaded, file))
    gs.files.load_module ("gsmbp_sweep_files", file, []);
    loaded = file;
  endif
  call = @gsmbp_sweep_files;
endfunction

function new = compile (who, sources, place)
  quote = @(text) ["'" strrep(text, "'", "'\\''") "'"];
  new = "new.oct";
  [words, links] = gs.files.hdf5_words (who);
  cc = strtrim (mkoctfile ("-p", "CC"));
  gs.files.run_command (who, sprintf (["cd %s && %s -std=gnu99 -O2 -fPIC %s -c %s %s %s && " ...
                             "mkoctfile -g0 -o new.oct %s sweep_files.o sweep_place.o " ...
                                       "sweep_table.o %s"], quote (place), cc, words, ...
                            cellfun (quote, sources(1:4), "UniformOutput", false){:}, links));
endfunction
