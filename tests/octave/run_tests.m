## run_tests (FILE): calls the test function of FILE (test_x.m); its checks print `ok` or `not ok`
## (gsmbp_check). An error is one more failure, unless it says that SUNDIALS is not there.
## Every test begins with the same random numbers.

function run_tests (file)
  [folder, name] = fileparts (file);
  addpath (folder);
  warning ("off", "Octave:shadowed-function");
  rand ("twister", 1);
  randn ("twister", 1);
  try
    feval (name);
  catch err
    if (any (strfind (err.message, "needs SUNDIALS 6 or 7, which is not installed")))
      printf ("ok left out without SUNDIALS: the rest of %s\n", name);
      return;
    end
    printf ("not ok %s: %s\n", name, strrep (err.message, "\n", " "));
    for level = err.stack(1:min (end, 6))'
      printf ("   at %s:%d\n", level.name, level.line);
    end
  end
end
