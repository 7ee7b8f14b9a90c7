## program = bench_ida (m, out): andrews_ida.c linked with the emitted Fortran of Andrews' squeezer,
## compiled as gsmbp_build compiles it; "" without SUNDIALS.

function program = bench_ida (m, out)
  here = fileparts (mfilename ("fullpath"));
  program = "";
  if (system ("echo '#include <ida/ida.h>' | gcc -E - >/dev/null 2>&1") != 0)
    return;
  end
  program = fullfile (out, "andrews_ida");
  alpha = find (strcmp (fieldnames (m.par), "baumgarte_alpha"));
  if (isempty (alpha))
    alpha = 0;
  end
  gfortran = strtrim (mkoctfile ("-p", "F77"));
  run (["cd '%s' && %s -O3 -march=native -fopenmp-simd -c -o andrews_ida_f.o " "andrews.f"], ...
       out, gfortran);
  run (["cd '%s' && gcc -std=gnu11 -O3 -march=native -fcx-limited-range -Wall -DNCST=%d " ...
        "-DNPAR=%d -DNY=%d -DBAUMGARTE=%d -c -o andrews_ida.o '%s'"],
       out, m.sizes.ncst, m.sizes.npar, m.sizes.ny, alpha - 1, fullfile (here, "andrews_ida.c"));
  run (["cd '%s' && %s -o andrews_ida andrews_ida.o andrews_ida_f.o " ...
        "build/double/common/libgsmbp.a -llapack -lblas -lsundials_ida -lsundials_nvecserial " ...
        "-lsundials_sunlinsoldense -lsundials_sunmatrixdense -lm"], out, gfortran);
end

function run (varargin)
  command = sprintf (varargin{:});
  [status, text] = system (["exec 2>&1; " command]);
  if (status != 0)
    error ("bench: this command failed\n%s\n%s", command, text);
  end
end
