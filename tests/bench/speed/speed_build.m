## [jobs, seconds] = speed_build (s, out): the emitted Fortran of a system compiled, as jobs for
## driver.c; CPU seconds of the compiler for each mode.
##
## jobs: struct array with who, mode, word (id, fd, mm, lin, jac; least: FD, LIN and their solution,
## which jac takes at least), library, start (file of its init),
## symbol, outputs. The last are the quad builds. Flags as for CasADi's code, -O3 -march=native; the
## batches (lit_v, num_v) have what gsmbp_build adds for them.

function [jobs, seconds] = speed_build (s, out)
  jobs = speed_job ();
  seconds = struct ();
  n = s.n;
  parts = {"", "gsmbp", {"id", n, "fd", n, "mm", n^2}};
  if (any (strcmp ({s.derive.requests}, "LIN")) && n <= 16)    # gfortran takes minutes beyond
    parts(end+1,:) = {"_lin", "gsmbp", {"lin", 3 * n^2}};
  end
  if (any (strcmp ({s.derive.requests}, "JAC")))
    parts(end+1,:) = {"_jac", "gsmbp", {"jac", 4 * n^2, "least", 4 * n^2}};
  end
  if (any (strcmp ({s.derive.requests}, "batch")))
    parts(end+1,:) = {"_v", "gsmbp_batch", {"id", n, "fd", n, "mm", n^2}};
  end
  for mode = s.modes
    for part = parts'
      m = [mode{1} part{1}];
      library = fullfile (s.folder, [m ".so"]);
      define = {"", "-DLIN", "-DJAC", "-DBATCH"}{strcmp(part{1}, {"", "_lin", "_jac", "_v"})};
      wide = any (strcmp (part{1}, {"_jac", "_v"}));
      flags = ["-O3 -march=native" {"", speed_batch_flags()}{1 + wide}];
      seconds.(m) = compile (s, m, "double", library, flags, define, ...
                             speed_runtime (out, "double"));
      for one = reshape (part{3}, 2, [])
        jobs(end+1) = speed_job (part{2}, mode{1}, one{1}, library, s.model, ...
                                 [one{1} {"", "_v"}{1 + strcmp(part{1}, "_v")}], one{2});
      end
    end
  end
  library = fullfile (s.folder, "quad.so");
  compile (s, "lit", "quad", library, "-O1 -freal-8-real-16", "-DQUAD", ...
           speed_runtime (out, "quad"));
  for word = {"id", "fd"}
    jobs(end+1) = speed_job ("gsmbp", "quad", word{1}, library, s.model, word{1}, 2 * s.n);
  end
  if (any (strcmp ({s.derive.requests}, "JAC")))
    library = fullfile (s.folder, "quad_jac.so");
    compile (s, "lit_jac", "quad", library, "-O1 -freal-8-real-16", "-DQUAD -DJAC", ...
             speed_runtime (out, "quad"));
    jobs(end+1) = speed_job ("gsmbp", "quad", "jac", library, s.model, "jac", 8 * n^2);
  end
end

function seconds = compile (s, mode, precision, library, flags, define, archive)
  here = fileparts (mfilename ("fullpath"));
  d = jsondecode (fileread (fullfile (s.folder, mode, [s.scene ".json"]))).dimensions;
  object = [library(1:end-3) ".o"];
  seconds = speed_cpu (sprintf ("gfortran %s -fPIC -c '%s' -o '%s'", flags, ...
                                fullfile (s.folder, mode, [s.scene ".f"]), object));
  if (s.loop)
    define = [define " -DLOOP"];
  end
  libraries = {"-llapack -lblas -lgfortran -lmvec", "-lgfortran -lquadmath"}{1 + strcmp ...
        (precision, "quad")};
  speed_cpu (sprintf (["gcc -O3 -march=native -fPIC -shared %s -DNAME=%s -DN=%d -DNCST=%d " ...
                       "-DNPAR=%d '%s' '%s' '%s' %s -lm -Wl,-Bsymbolic -o '%s'"], define, ...
                           tolower (s.scene), s.n,
    d.ncst, d.npar, fullfile (here, "ours.c"), object, archive, libraries, library));
end
