## part = gsmbp__archive (precision)
## The run times in Fortran and in C as all modules of a PRECISION share them: the name of their
## file, the words and flags of the compilers, what it is made of (as gsmbp__is_built takes them).

function part = gsmbp__archive (precision)
  [~, flags, own] = gsmbp__fortran_flags (precision);
  fortran = gsmbp__place ("share", "fortran");
  solve = {"lapack", "plain"}{1 + strcmp(precision, "quad")};
  c = gsmbp__place ("share", "c");
  engine = gsmbp__place ("share", "engine", "host");
  sources = [glob(fullfile (fortran, "*", "*.f")); glob(fullfile (fortran, "solve", solve, ...
                                                                  "*.f")); ...
             glob(fullfile (c, "gsmbp", "*.h")); glob(fullfile (c, "*", "*.c")); ...
             glob(fullfile (c, "*", "*", "*.c")); glob(fullfile (engine, "*.[ch]"))];
  if (strcmp (precision, "double"))
    sources = [sources; glob(fullfile (engine, "implicit", "*.[ch]"))];
  endif
  words = strjoin ({gsmbp__mkoctfile("F77"), flags, gsmbp__mkoctfile("CC"), own});
  part = {"libgsmbp.a", words, sources};
endfunction
