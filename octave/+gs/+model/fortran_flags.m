## [flags, common, c, lanes] = gs.model.fortran_flags (precision)
## The options of the compiler for the Fortran of a scene, for that of the run time, which all
## scenes share, for the run time in C and for its loops over lanes (share/engine/host/lanes), in
## that PRECISION, "double" or "quad".

function [flags, common, c, lanes] = fortran_flags (precision)
  ## never -ffast-math: it deletes the tests for what is no number.  Statements
  ## are not packed into vectors: a copy of a number that is computed so may
  ## differ in its last bit (M would not be symmetric), GSSC is slower, and
  ## gfortran 14 takes the vector versions of SIN, COS and ATAN2 of glibc, with
  ## errors up to 4 units in the last place (their loops: GCC$ NOVECTOR).  The
  ## small loops of the run time are faster without the vectorization of -O3, on
  ## places of their own in the cache, and copies of three numbers without a call
  ## of memcpy.
  ## The loops of the batches (C$OMP SIMD) take the widest vectors there are.
  ## Three passes that look at long straight lines again and again cost a third of
  ## the time of compiling, and gain nothing.
  processor = gs.files.processor_flag ();
  own = ["-O3 --param=lra-max-considered-reload-pseudos=50 -fno-gcse-after-reload -fno-dse " ...
         "-fno-tree-slp-vectorize"];
  scene = [processor " -fopenmp-simd" widest() " -frecursive -fPIC"];
  flags = [own scene];
  common = ["-O2 -fno-tree-loop-distribute-patterns -falign-functions=64 -falign-loops=32 " ...
            "-fno-tree-slp-vectorize" scene];
  c = ["-std=c99 -O2 -ffp-contract=fast -falign-functions=64 -falign-loops=32" ...
       limited_range() processor " -fPIC"];
  ## square roots in vectors leave errno as it is; what becomes branches has no vectors
  lanes = [strrep(c, " -O2 ", " -O3 ") " -fno-math-errno -fno-tree-pre -fno-thread-jumps " ...
           "-fno-tree-slp-vectorize -fopenmp-simd -DGS_OPENMP_SIMD" widest()];
  if (strcmp (precision, "quad"))
    flags = common = ["-O2" processor " -freal-8-real-16 -frecursive -fPIC"];
    c = ["-std=c99 -O2" processor " -DGSMBP_QUAD -fPIC"];
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

## complex products of the implicit methods are without tests for what is no number, where the
## compiler has an option for that (clang before 18 has none)
function option = limited_range ()
  persistent known = [];
  option = " -fcx-limited-range";
  if (isempty (known))
    cc = gs.files.mkoctfile_word ("CC");
    known = system ([cc option " -E -x c /dev/null >/dev/null 2>&1"]) == 0;
  endif
  option = option(1:end*known);
endfunction
