## archive = speed_runtime (out, precision): what all scenes share ("double", "quad"), compiled when
## it is older than its sources.

function archive = speed_runtime (out, precision)
  root = fileparts (fileparts (fileparts (fileparts (mfilename ("fullpath")))));
  folder = fullfile (out, ["runtime_" precision]);
  archive = fullfile (folder, "runtime.a");
  quad = strcmp (precision, "quad");
  body = {"lapack", "plain"}{1 + quad};
  sources = [glob(fullfile (root, "share", "fortran", "*", "*.f")); ...
             glob(fullfile (root, "share", "fortran", "solve", body, "*.f"))];
  if (! exist (archive, "file") ...
        || stat (archive).mtime < max (cellfun (@(f) stat (f).mtime, sources)))
    [~, ~] = unlink (archive);
    [~, ~] = mkdir (folder);
    speed_cpu (sprintf (["cd '%s' && gfortran -O2 -fno-tree-slp-vectorize -march=native -fPIC " ...
                         "%s -c%s && ar rcs runtime.a *.o"], folder,
      {speed_batch_flags(), "-freal-8-real-16"}{1 + quad}, sprintf (" '%s'", sources{:})));
  end
end
