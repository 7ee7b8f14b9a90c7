## r = gsmbp__sweep_on_disk (who, s, j)
## The runs of a sweep (gsmbp__sweep_runs) by its journal J, the table in J.file, and the folder of
## the chunks gone when it is there.

function r = gsmbp__sweep_on_disk (who, s, j)
  if (j.done)
    r = of_file (j.file, columns (s.table), numel ([s.kept.whole]) - nnz ([s.kept.whole]));
  else
    r = gsmbp__sweep_runs (who, s, j);
    if (! isempty (r.stopped))   # the chunks stay
      return;
    endif
    j.call ("export", j.job, j.folder, j.file);
  endif
  if (exist (j.folder, "dir"))
    confirm_recursive_rmdir (false, "local");
    rmdir (j.folder, "s");
  endif
endfunction

## a finished table; load gives arrays transposed
function r = of_file (file, varied, kept)
  w = load ("-hdf5", file);
  n = numel (w.ok);
  r = struct ("values", reshape (w.table, varied + kept, n)(varied+1:end,:)', "ok", ...
              logical (w.ok(:)), "reached", w.reached(:), "reason", {repmat({""}, n, 1)}, ...
              "whole", {{}}, "seconds", 0, "made", true (n, 1), "stopped", "", "outside", ...
              zeros (0, 2));
  if (isfield (w, "failed"))
    r.reason(double (w.failed.run)) = cellstr (w.failed.reason);
  endif
endfunction
