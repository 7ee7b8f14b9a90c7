## file = gs.model.compile_module (json, source, folder, precision, symbol, input)
## The .oct module of a scene.  JSON: the decoded description; SOURCE: its
## Fortran; FOLDER: the build folder; PRECISION: "double" or "quad"; SYMBOL:
## the name by which Octave will call it; INPUT: "" or the user's Fortran file
## with SUBROUTINE GSVIN.  Each part is built only where the texts that it is
## made of have changed, in a folder of its own, and then moved into place; what all scenes share
## is compiled once for each user.

function file = compile_module (json, source, folder, precision, symbol, input)
  who = "gsmbp_build";
  w = words (fullfile (folder, precision, "common"), precision);
  here = fullfile (folder, precision, json.name);
  file = fullfile (here, [symbol ".oct"]);
  own = {source; [source(1:end-2) ".json"]};
  if (! isempty (input))
    own{end+1} = input;
  endif
  flags = strjoin ({w.flags, w.archive{2}, OCTAVE_VERSION()});
  made = gs.files.build_once (who, file, flags, [own; w.runtime; w.generic; w.scene], ...
                       @(place) scene (who, w, json, source, symbol, input, place));
  if (made)   # modules of earlier contents
    old = setdiff (glob (fullfile (here, [symbol(1:end-8) "*.oct*"])), {file; [file ".md5"]});
    cellfun (@delete, old);
  endif
endfunction

## compilers, flags, folders; what the run time, the generic part and the tables of a scene are
## made of
function w = words (common, precision)
  quad = strcmp (precision, "quad");
  w = struct ("precision", precision, "common", common, ...
              "glue", gs.files.own_place ("octave", "glue"), "c", ...
              gs.files.own_place ("share", "engine", "core"), ...
              "engine", gs.files.own_place ("share", "engine"), ...
              "cc", gs.files.mkoctfile_word ("CC"), "f77", gs.files.mkoctfile_word ("F77"), ...
              "libraries", "-llapack -lblas", "define", {{"", "-DGSMBP_QUAD"}{1 + quad}});
  if (quad)
    w.libraries = quadmath ();
  endif
  [w.flags, w.common_flags, w.c_flags, w.lane_flags] = gs.model.fortran_flags (precision);
  headers = [glob(fullfile (w.c, "gsmbp", "*.h")); glob(fullfile (w.engine, "host", "*.h"))
             glob(fullfile (w.engine, "host", ...
                            {"implicit", "derivatives", "ensemble", "linear", "assemble", ...
                             "reach", "run", "collocation", "optimize"}, "*.h"))];
  w.archive = gs.model.runtime_archive (precision);
  w.runtime = w.archive{3};
  w.generic = [headers; glob(fullfile (w.glue, "*.h")); {fullfile(w.glue, "gsmbp_module.cc")}];
  ## the generic part of all modules: as fast by -O1 as by -O2, in half the time; a mkoctfile with
  ## -flto (Debian 13) would compile it once more for each scene, in 5 s
  w.options = strtrim (["-g0 -O1 -fno-lto -Ic -Iengine " w.define]);
  w.object = {"gsmbp_module.o", [OCTAVE_VERSION() " " w.options], w.generic};
  w.scene = cellfun (@(name) fullfile (w.glue, name), {"gsmbp_scene.c"; "module.map"}, ...
                     "UniformOutput", false);
endfunction

## the library of quadruple precision, which compilers for ARM64 neither have nor need
function text = quadmath ()
  [~, file] = system ([gs.files.mkoctfile_word("CC") " -print-file-name=libquadmath.so"]);
  text = {"", "-lquadmath"}{1 + any(file == "/")};
endfunction

## what all scenes share
function share (who, w)
  build = @(part, make, compiler) gs.files.build_once (who, fullfile (w.common, part{1}), ...
      part{2:3}, ...
                                                make, compiler);
  build (w.archive, @(place) run_time (who, w, place), w.archive{2});
  own = mkoctfile_command ();
  build (w.object, @(place) generic (who, w, place), ...
         sprintf ("$(%s -p CXX) $(%s -p ALL_CXXFLAGS) %s", own, own, w.options));
endfunction

function new = run_time (who, w, place)
  new = "libgsmbp.a";
  in_lanes = ! cellfun (@isempty, regexp (w.runtime, 'host/lanes/[^/]*$'));
  lanes = "";
  if (any (in_lanes))
    lanes = sprintf ("%s %s -I../c -I../engine -c%s && ", w.cc, w.lane_flags, ...
                     of_kind (w.runtime(in_lanes), "c"));
  endif
  gs.files.run_command (who, sprintf (["cd %s && ln -s %s c && ln -s %s engine && " ...
                                       "mkdir o && cd o && %s %s -I../c -I../engine -c%s && %s" ...
                                       "for f in *.o; do mv $f c_$f; done && cd .. && " ...
                                       "%s %s -c%s && ar rcs libgsmbp.a *.o o/*.o"], ...
                                      quote (place), quote (w.c), quote (w.engine), w.cc, ...
                                      w.c_flags, of_kind (w.runtime(! in_lanes), "c"), lanes, ...
                                      w.f77, w.common_flags, of_kind (w.runtime, "f")), ...
              "compiling the run times, 1 of 2", 18);
endfunction

## the names of the files of that kind, as the shell takes them
function text = of_kind (files, kind)
  files = files(! cellfun (@isempty, regexp (files, ['\.' kind '$'])));
  text = sprintf (" %s", cellfun (@quote, files, "UniformOutput", false){:});
endfunction

function new = generic (who, w, place)
  new = "module.o";
  command = ["cd %s && ln -s %s glue && ln -s %s c && ln -s %s engine && " ...
             "%s %s -c -o module.o glue/gsmbp_module.cc"];
  gs.files.run_command (who, sprintf (command, quote (place), quote (w.glue), quote (w.c), ...
                            quote (w.engine), mkoctfile_command (), w.options), ...
              "compiling the run time, 2 of 2", 12);
endfunction

function new = scene (who, w, json, source, symbol, input, place)
  new = "module.oct";
  share (who, w);
  compile = @(file, object) gs.files.run_command (who, sprintf ("cd %s && %s %s -c -o %s %s", ...
                                                      quote (place), w.f77, w.flags, object, ...
                                                      quote (file)), ...
                                       ["compiling " json.name], seconds_for (file));
  gs.files.write_text (who, fullfile (place, "gsmbp_sizes.h"), ...
                gs.model.sizes_header (json, symbol, ! isempty (input)));
  compile (source, "scene_f.o");
  user = "";
  if (! isempty (input))
    compile (input, "input.o");
    user = "input.o";
  endif
  ## mkoctfile gives its words to a shell once more: names without special characters
  gs.files.run_command (who, sprintf (["cd %s && ln -s %s glue && ln -s %s common && " ...
                             "ln -s %s c && ln -s %s engine && %s -O2 -fPIC %s -I. -Iglue -Ic " ...
                             "-Iengine " ...
                             "-c -o scene.o glue/gsmbp_scene.c && " ...
                             "%s -o module.oct common/gsmbp_module.o scene.o scene_f.o %s " ...
                             "common/libgsmbp.a %s %s -Wl,--version-script=glue/module.map"], ...
                            quote (place), quote (w.glue), quote (w.common), quote (w.c), ...
                            quote (w.engine), w.cc, w.define, ...
                            mkoctfile_command (), user, w.libraries, ...
                            gs.files.mkoctfile_word ("FLIBS")));
endfunction

## gfortran takes some 0.7 ms a line
function s = seconds_for (file)
  s = 7e-4 * sum (fileread (file) == "\n");
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
