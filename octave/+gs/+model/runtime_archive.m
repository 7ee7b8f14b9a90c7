## part = gs.model.runtime_archive (precision)
## The run times in Fortran and in C as all modules of a PRECISION share them: the name of their
## file, the words and flags of the compilers, what it is made of (as gs.files.is_built takes them).

function part = runtime_archive (precision)
  [~, flags, own, lanes] = gs.model.fortran_flags (precision);
  fortran = gs.files.own_place ("share", "fortran");
  solve = {"lapack", "plain"}{1 + strcmp(precision, "quad")};
  c = gs.files.own_place ("share", "engine", "core");
  engine = gs.files.own_place ("share", "engine", "host");
  folders = {".", "derivatives", "ensemble", "linear", "assemble", "reach", "run", ...
             "collocation", "optimize", "implicit", "lanes"};
  folders = folders(1:end-2*strcmp (precision, "quad"));
  sources = [glob(fullfile (fortran, "*", "*.f")); glob(fullfile (fortran, "solve", solve, ...
                                                                  "*.f")); ...
             glob(fullfile (c, "gsmbp", "*.h")); glob(fullfile (c, "*", "*.c")); ...
             glob(fullfile (c, "*", "*", "*.c")); glob(fullfile (engine, folders, "*.[ch]"))];
  words = strjoin ({gs.files.mkoctfile_word("F77"), flags, gs.files.mkoctfile_word("CC"), own, ...
                    lanes});
  part = {"libgsmbp.a", words, sources};
endfunction
