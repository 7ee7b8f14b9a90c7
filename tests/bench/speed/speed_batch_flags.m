## flags = speed_batch_flags (): what gsmbp_build adds for the batches: loops marked C$OMP SIMD in
## the widest vectors.

function flags = speed_batch_flags ()
  flags = " -fopenmp-simd";
  if (! isempty (regexp (computer (), 'x86_64|i.86', "once")))
    flags = [flags " -mprefer-vector-width=512"];
  end
end
