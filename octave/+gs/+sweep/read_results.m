## r = gs.sweep.read_results (who, s, j)
## The runs of a sweep (gs.sweep.run_blocks) by its journal J, the table in J.file, and the folder
## of the chunks gone when it is there.

function r = read_results (who, s, j)
  if (j.done)
    r = of_file (who, j.file, columns (s.table), nnz (! [s.kept.whole]), nnz ([s.kept.whole]));
  else
    r = gs.sweep.run_blocks (who, s, j);
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
function r = of_file (who, file, varied, kept, wholes)
  w = read_whole (who, file, wholes);
  n = numel (w.ok);
  r = struct ("values", reshape (w.table, varied + kept, n)(varied+1:end,:)', "ok", ...
              logical (w.ok(:)), "reached", w.reached(:), "reason", {repmat({""}, n, 1)}, ...
              "whole", {{}}, "seconds", 0, "made", true (n, 1), "stopped", "", "outside", ...
              zeros (0, 2), "sharp", struct ([]));
  if (isfield (w, "failed"))
    r.reason(double (w.failed.run)) = cellstr (w.failed.reason);
  endif
endfunction

## what load gives of a table: it leaves out what has not its checksum
function w = read_whole (who, file, wholes)
  w = struct ();
  try
    w = load ("-hdf5", file);
  end_try_catch
  has = @(names) all (isfield (w, names));
  sound = has ({"table", "ok", "reached", "names", "units"});
  sound = sound && (wholes == 0 || has ({"times", "whole"}) && numfields (w.whole) == wholes);
  sound = sound && (all (w.ok) || has ("failed") && all (isfield (w.failed, {"run", "reason"})));
  if (! sound)
    error ("%s: %s is damaged: not all of it has its checksum; remove it to begin anew", who, file);
  endif
endfunction
