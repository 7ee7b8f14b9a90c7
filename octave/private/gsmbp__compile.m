## file = gsmbp__compile (json, source, folder, precision, symbol, input)
## The .oct module of a scene.  JSON: the decoded description; SOURCE: its
## Fortran; FOLDER: the build folder; PRECISION: "double" or "quad"; SYMBOL:
## the name by which Octave will call it; INPUT: "" or the user's Fortran file
## with SUBROUTINE GSVIN.  Each part is built only when it is older than what
## it is made of, in a folder of its own, and then moved into place.

function file = gsmbp__compile (json, source, folder, precision, symbol, input)
  who = "gsmbp_build";
  glue = gsmbp__place ("octave", "glue");
  c = gsmbp__place ("share", "c");
  cc = strtrim (mkoctfile ("-p", "CC"));
  fortran = gsmbp__place ("share", "fortran");
  quad = strcmp (precision, "quad");
  f77 = strtrim (mkoctfile ("-p", "F77"));
  ## never -ffast-math: it deletes the tests for what is no number.  Statements
  ## are not packed into vectors: a copy of a number that is computed so may
  ## differ in its last bit (M would not be symmetric), and GSSC is slower.  The
  ## small loops of the run time are faster without the vectorization of -O3, on
  ## places of their own in the cache, and copies of three numbers without a call
  ## of memcpy.
  ## The loops of the batches (C$OMP SIMD) take the widest vectors there are.
  flags = ["-O3 -fno-tree-slp-vectorize -march=native -fopenmp-simd" widest() " -frecursive -fPIC"];
  common_flags = ["-O2 -fno-tree-loop-distribute-patterns -falign-functions=64 -falign-loops=32" ...
                  flags(4:end)];
  body = "lapack";
  libraries = "-llapack -lblas";
  define = "";
  if (quad)
    flags = common_flags = "-O2 -march=native -freal-8-real-16 -frecursive -fPIC";
    body = "plain";
    libraries = "-lquadmath";
    define = "-DGSMBP_QUAD";
  endif
  ## what all scenes share, made anew where one of its sources says something else
  common = fullfile (folder, precision, "common");
  runtime = [glob(fullfile (fortran, "*", "*.f")); glob(fullfile (fortran, "solve", body, "*.f"))];
  archive = fullfile (common, "libgsmbp.a");
  parts = [runtime; glob(fullfile (glue, "*.*")); glob(fullfile (c, "gsmbp", "*.h")); ...
           {fullfile(c, "inputs", "gslay.c")}];
  stamp = flags_stamp (common, [f77 " " common_flags " " digest(parts)]);
  if (gsmbp__older (archive, {stamp}))
    place = scratch (common);
    guard = onCleanup (@() remove (place));
    ## the layout of a run's plan is that of the run time in C (glue/run_plan.h)
    gsmbp__run (who, sprintf (["cd %s && ln -s %s c && " ...
                               "%s -std=c99 -O2 -fPIC -Ic -c c/inputs/gslay.c && " ...
                               "%s %s -c%s && ar rcs libgsmbp.a *.o"], quote (place), quote (c), ...
                              cc, f77, common_flags,
                              sprintf (" %s", ...
                                  cellfun (@quote, runtime, "UniformOutput", false){:})));
    gsmbp__put_in_place (who, fullfile (place, "libgsmbp.a"), archive);
  endif
  module = fullfile (common, "gsmbp_module.o");
  if (gsmbp__older (module, {stamp}))
    place = scratch (common);
    guard = onCleanup (@() remove (place));
    gsmbp__run (who, ...
                sprintf (["cd %s && ln -s %s glue && ln -s %s c && " ...
                          "%s %s -Ic -c -o module.o glue/gsmbp_module.cc"], quote (place), ...
                         quote (glue), quote (c), mkoctfile_command (), define));
    gsmbp__put_in_place (who, fullfile (place, "module.o"), module);
  endif

  ## the scene
  here = fullfile (folder, precision, json.name);
  file = fullfile (here, [symbol ".oct"]);
  stamp = flags_stamp (here, [f77 " " flags " " input]);
  sources = {source; [source(1:end-2) ".json"]; archive; module; stamp};
  if (! isempty (input))
    sources{end+1} = input;
  endif
  if (gsmbp__older (file, sources))
    place = scratch (here);
    guard = onCleanup (@() remove (place));
    gsmbp__write (who, fullfile (place, "gsmbp_sizes.h"), ...
                  sizes_header (json, symbol, ! isempty (input)));
    say_if_long (who, source);
    gsmbp__run (who, ...
                sprintf ("cd %s && %s %s -c -o scene_f.o %s", quote (place), f77, flags, ...
                         quote (source)));
    user = "";
    if (! isempty (input))
      gsmbp__run (who, ...
                  sprintf ("cd %s && %s %s -c -o input.o %s", quote (place), f77, flags, ...
                           quote (input)));
      user = "input.o";
    endif
    ## mkoctfile gives its words to a shell once more: names without special characters
    gsmbp__run (who, sprintf (["cd %s && ln -s %s glue && ln -s %s common && " ...
                               "%s -O2 -fPIC -I. -Iglue -c -o scene.o glue/gsmbp_scene.c && " ...
                               "%s -o module.oct common/gsmbp_module.o scene.o scene_f.o %s " ...
                               "common/libgsmbp.a %s %s -Wl,--version-script=glue/module.map"],
                              quote (place), quote (glue), quote (common), cc, ...
                              mkoctfile_command (), user, libraries, ...
                              strtrim (mkoctfile ("-p", "FLIBS"))));
    gsmbp__put_in_place (who, fullfile (place, "module.oct"), file);
    ## modules of earlier contents
    old = setdiff (glob (fullfile (here, [symbol(1:end-8) "*.oct*"])), {file; [file ".md5"]});
    cellfun (@delete, old);
  endif
endfunction

## gcc prefers vectors of 256 bits where the processor has 512; an option of
## the x86 compilers only
function option = widest ()
  option = "";
  if (! isempty (regexp (computer (), 'x86_64|i.86', "once")))
    option = " -mprefer-vector-width=512";
  endif
endfunction

## gfortran takes some 0.7 ms a line: what will take more than 10 s says so
function say_if_long (who, source)
  lines = sum (fileread (source) == "\n");
  if (lines > 14000)
    printf ("%s: %s has %d lines; compiling it takes about %d s\n", who, source, lines, ...
            10 * ceil (lines / 14000));
    fflush (stdout);
  endif
endfunction

function text = quote (file)
  text = ["'" strrep(file, "'", "'\\''") "'"];
endfunction

function command = mkoctfile_command ()
  command = quote (fullfile (OCTAVE_HOME (), "bin", ["mkoctfile-" OCTAVE_VERSION]));
  if (! exist (command(2:end-1), "file"))
    command = "mkoctfile";
  endif
endfunction

function place = scratch (folder)
  place = fullfile (folder, sprintf (".new-%d-%d", getpid (), randi (1e9)));
  gsmbp__folder ("gsmbp_build", place);
endfunction

function remove (place)
  confirm_recursive_rmdir (false, "local");
  rmdir (place, "s");
endfunction

## a file that is as new as the last change of TEXT
function file = flags_stamp (folder, text)
  file = fullfile (folder, "flags");
  if (! exist (file, "file") || ! strcmp (fileread (file), text))
    gsmbp__write ("gsmbp_build", file, text);
  endif
endfunction

## what the files say; their times do not tell those of two installed versions apart
function text = digest (files)
  texts = cellfun (@fileread, files, "UniformOutput", false);
  text = hash ("md5", [texts{:}]);
endfunction

## a size, 0 where the JSON does not say
function n = size_of (d, name)
  n = 0;
  if (isfield (d, name))
    n = d.(name);
  endif
endfunction

## the requests that were asked for and are not there, with their reasons, as a constant of C
function text = left_out (json)
  text = "";
  if (isfield (json, "left_out") && isstruct (json.left_out))
    for one = json.left_out(:)'
      text = [text, "\n", one.request, ": ", one.reason];
    endfor
  endif
  text = strrep (undo_string_escapes ([text "\n"]), "?", "\\?");
endfunction

## the macros of gsmbp_scene.c; sizes are those that gsmbp_scene.h lists
function text = sizes_header (json, symbol, has_input)
  header = fileread (gsmbp__place ("octave", "glue", "gsmbp_scene.h"));
  members = {[".name = \"" json.name "\""], [".symbol = \"" symbol "\""], ...
             [".left_out = \"" left_out(json) "\""]};
  for name = sizes_in (header)
    members{end+1} = sprintf (".%s = %d", name{1}, size_of (json.dimensions, name{1}));
  endfor
  base = 0;
  if (isfield (json, "base_parameters"))
    base = numel (json.base_parameters);
  endif
  by = 0;
  if (isfield (json, "sensitivity"))
    by = numel (cellstr (json.sensitivity));
  endif
  sets = gsmbp__orientation (json);
  skeleton = gsmbp__skeleton (json);
  np = sum (skeleton.points) + numel ([skeleton.parts.bodies]);
  modes = 0;
  if (isfield (json, "events") && ! isempty (json.events))
    modes = [json.events.input, 0];
  endif
  members{end+1} = sprintf (".np = %d, .nbase = %d, .nsp = %d, .nsets = %d", np, base, by, ...
                            rows (sets));
  [routines, meanings, declared] = subroutines (json);
  if (has_input)
    declared{end+1} = "gsvin_";
    members{end+1} = ".vin = gsvin_";
  endif
  text = [sprintf("#define GSMBP_INSTALL G%s\n", symbol), ...
          "#define GSMBP_DECLARE ", sprintf("extern void %s (void); ", declared{:}), "\n", ...
          "#define GSMBP_SETS ", strjoin(cellstr (num2str ([sets'(:); 0])), ", "), "\n", ...
          "#define GSMBP_MODES ", sprintf("%d, ", modes), "\n", ...
          "#define GSMBP_TABLE ", strjoin(members, ", "), "\n", ...
          "#define GSMBP_ROUTINES ", routines{:}, "\n#define GSMBP_MEANINGS ", meanings{:}, "\n"];
endfunction

## rows of C: the emitted subroutines by the ends of their names, the sentences of their INFO
function [routines, meanings, declared] = subroutines (json)
  routines = meanings = declared = {};
  list = json.subroutines;
  if (! iscell (list))
    list = num2cell (list);
  endif
  for row = list(:)'
    full = tolower (row{1}.name);
    name = full(numel (json.name)+2:end);
    declared{end+1} = [full "_"];
    routines{end+1} = sprintf ("{ \"%s\", %s_, \"%s\" }, ", name, full, gsmbp__signature (row{1}));
    if (isfield (row{1}, "info") && ! isempty (row{1}.info))
      told = row{1}.info([row{1}.info.code] > 0)(:)';
      meanings = [meanings, arrayfun(@(one) sentence (name, one), told, "UniformOutput", false)];
    endif
  endfor
endfunction

function row = sentence (name, info)
  above = " (and so does every greater INFO)";
  row = sprintf ("{ \"%s\", %d, %d, \"%s\" }, ", name, info.code, ...
                 ! isempty (strfind (info.meaning, above)), ...
                 regexprep (strrep (info.meaning, above, ""), '(["\\])', '\\$1'));
endfunction

## the names in the list X (one) X (two) ... of a header
function names = sizes_in (header)
  body = regexp (header, '#define GSMBP_SIZES\(X\)((?:[^\n]*\\\n)*[^\n]*)', "tokens", "once"){1};
  names = [regexp(body, 'X \((\w+)\)', "tokens"){:}];
endfunction
