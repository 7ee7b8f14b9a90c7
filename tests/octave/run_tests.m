## run_tests (FILE): calls the test function of FILE (test_x.m); its checks print `ok` or `not ok`
## (gsmbp_check). An error is one more failure.

function run_tests (file)
  [folder, name] = fileparts (file);
  addpath (folder);
  warning ("off", "Octave:shadowed-function");
  try
    feval (name);
  catch err
    printf ("not ok %s: %s\n", name, strrep (err.message, "\n", " "));
    for level = err.stack(1:min (end, 6))'
      printf ("   at %s:%d\n", level.name, level.line);
    end
  end
end
