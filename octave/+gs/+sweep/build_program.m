## file = gs.sweep.build_program (who, s, p, records, folder)
## The program of a sweep in a FOLDER of its own: Fortran and C, a Makefile, the job, a script for
## Slurm; built there.  S: as of gs.sweep.run_blocks; P: a run (gs.run.plan_many); RECORDS: of
## gs.sweep.record_names.  FILE: the program.

function file = build_program (who, s, p, records, folder)
  m = s.m;
  if (! strcmp (m.precision, "double"))
    error ("%s: option program: expected a model in double precision, found %s", who, m.precision);
  endif
  gs.sweep.check_place (who, folder, records{1,2});
  folder = make_absolute_filename (folder);
  gs.files.make_folder (who, folder);
  records = [records; sweep_records(s); run_records(m, p.given)];
  take_sources (who, m, folder);
  put (who, fullfile (folder, "gsmbp_sizes.h"), ...
       gs.model.sizes_header (m.json, m.symbol, ! isempty (m.sources{2})));
  put (who, fullfile (folder, "Makefile"), makefile (p.method));
  gs.files.write_text (who, fullfile (folder, "sweep.slurm"), filled ("sweep.slurm", "@name@", ...
                                                                      m.name));
  gs.files.write_text (who, fullfile (folder, "sweep.job"), gs.sweep.job_text (records));
  take_archive (who, m, fullfile (folder, "build"));
  gs.files.run_command (who, sprintf ("cd '%s' && make", strrep (folder, "'", "'\\''")));
  file = fullfile (folder, "sweep");
endfunction

## what differs from run to run, with those whose parameters break a rule of the scene; what is kept
function records = sweep_records (s)
  m = s.m;
  [~, which] = ismember (s.names, fieldnames (m.par));
  broken = gs.model.broken_rules (m, cell2struct (num2cell (s.table, 1), s.names, 2));
  lines = cellfun (@(i, why) sprintf ("%d\t%s\n", i, strrep (why, "\n", " ")), ...
                   num2cell (find (! strcmp (broken, ""))), broken(! strcmp (broken, "")), ...
                   "UniformOutput", false);
  kept = s.kept;
  records = {"symbol", m.symbol; "broken", [lines{:}, ""]; "which", which
             "way", [kept.way]; "number", [kept.number]; "time", [kept.time]
             "groups", gs.events.group_names(m); "lanes", s.lanes};
endfunction

## a run of the model M, GIVEN to the engine (glue/asked_run.h): the options, the start, the inputs
function records = run_records (m, given)
  names = {"method", "loops", "step", "rtol", "atol", "maxstep", "maxsteps", "maxorder", ...
           "drift", "project", "x0", "par", "nominal", "modes", "memory", "kind", "constants", ...
           "table", "motion", "planned", "reference", "gain", "limits", "breaks"};
  records = {"cst", typecast(m.cst(:)', "double")};
  for name = names
    x = given.(name{1});
    if (isstruct (x))
      x = [x.nc, x.np, x.k, x.numbers];
    endif
    records(end+1,:) = {name{1}, x};
  endfor
endfunction

function take_sources (who, m, folder)
  parts = {"gsmbp_scene.?", "sweep_*"};
  for file = glob (fullfile (gs.files.own_place ("octave", "glue"), parts))'
    take (who, file{1}, fullfile (folder, "glue"));
  endfor
  take (who, gs.files.own_place ("share", "make", "find_header"), fullfile (folder, "glue"));
  fortran = gs.files.own_place ("share", "fortran");
  for file = [glob(fullfile (fortran, "*", "*.f")); glob(fullfile (fortran, "solve", "lapack", ...
                                                                   "*.f"))]'
    take (who, file{1}, fullfile (folder, "fortran"));
  endfor
  for home = {gs.files.own_place("share", "engine", "core"), gs.files.own_place("share", "engine")
              {"*", "*/*"}, {"host", "host/*"}}
    for file = glob (fullfile (home{1}, home{2}, "*.[ch]"))'
      take (who, file{1}, fullfile (folder, "c", fileparts (file{1}(numel (home{1})+2:end))));
    endfor
  endfor
  put (who, fullfile (folder, "scene.f"), fileread (m.sources{1}));
  if (! isempty (m.sources{2}))
    put (who, fullfile (folder, "input.f"), fileread (m.sources{2}));
  endif
endfunction

## the program links what the modules share, where that is there; else make makes it
function take_archive (who, m, folder)
  gs.files.make_folder (who, folder);
  part = gs.model.runtime_archive ("double");
  [name, flags, sources] = part{:};
  made = fullfile (fileparts (fileparts (m.file)), "common", name);
  if (gs.files.is_built (made, flags, sources))
    put (who, fullfile (folder, name), fileread (made));
  else
    gs.files.discard_file (fullfile (folder, name));
  endif
endfunction

function take (who, file, folder)
  [~, name, kind] = fileparts (file);
  put (who, fullfile (folder, [name kind]), fileread (file));
endfunction

## a file that says the same keeps its time: make compiles what has changed
function put (who, file, text)
  if (! exist (file, "file") || ! strcmp (fileread (file), text))
    gs.files.write_text (who, file, text);
  endif
endfunction

function text = makefile (method)
  [flags, common, of_c, lanes] = gs.model.fortran_flags ("double");
  text = filled ("Makefile", "@fortran@", strtrim (mkoctfile ("-p", "F77")), "@scene@", flags, ...
                 "@runtime@", common, "@engine@", of_c, "@method@", method, "@lanes@", lanes);
endfunction

## a file of share/sweep, its marks filled in
function text = filled (name, varargin)
  text = fileread (gs.files.own_place ("share", "sweep", name));
  for k = 1:2:numel (varargin)
    text = strrep (text, varargin{k}, varargin{k+1});
  endfor
endfunction
