## jobs = speed_peaks (out): jobs for driver.c that say what a core does at most (peak.c): who =
## "peak", mode "lit"; words fma_one, fma_many: 10240 multiplications and additions by single
## numbers and by vectors; gssc_eight, gsscv_eight, atan2_eight, gsatv_eight: eight angles one by
## one and at once.

function jobs = speed_peaks (out)
  here = fileparts (mfilename ("fullpath"));
  library = fullfile (out, "peak.so");
  archive = speed_runtime (out, "double");
  width = speed_batch_flags ();
  speed_cpu (sprintf (["gcc -O3 -march=native -ffp-contract=fast -fno-tree-vectorize %s -fPIC " ...
                       "-shared '%s' '%s' -lgfortran -lmvec -lm -Wl,-Bsymbolic -o '%s'"], width, ...
                      fullfile (here, "peak.c"), archive, library));
  words = {"fma_one", "fma_many", "gssc_eight", "gsscv_eight", "atan2_eight", "gsatv_eight"};
  jobs = speed_job ();
  for word = words
    jobs(end+1) = speed_job ("peak", "lit", word{1}, library, "-", word{1}, 1);
  end
end
