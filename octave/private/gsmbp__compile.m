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
  [flags, common_flags] = gsmbp__fortran_flags (precision);
  body = "lapack";
  libraries = "-llapack -lblas";
  define = "";
  if (quad)
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
                  gsmbp__sizes_header (json, symbol, ! isempty (input)));
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
