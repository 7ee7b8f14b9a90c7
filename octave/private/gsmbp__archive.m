## part = gsmbp__archive (precision)
## The run time in Fortran as all modules of a PRECISION share it: the name of its file, the words
## and flags of its compiler, what it is made of (as gsmbp__is_built takes them).

function part = gsmbp__archive (precision)
  [~, flags] = gsmbp__fortran_flags (precision);
  fortran = gsmbp__place ("share", "fortran");
  solve = {"lapack", "plain"}{1 + strcmp(precision, "quad")};
  c = gsmbp__place ("share", "c");
  engine = gsmbp__place ("share", "engine", "host");
  sources = [glob(fullfile (fortran, "*", "*.f")); glob(fullfile (fortran, "solve", solve, ...
                                                                  "*.f")); ...
             glob(fullfile (c, "gsmbp", "*.h")); ...
             {fullfile(c, "inputs", "gslay.c")}; glob(fullfile (engine, "*.[ch]"))];
  part = {"libgsmbp.a", [gsmbp__mkoctfile("F77") " " flags], sources};
endfunction
