## ns = speed_run (s, X, jobs, "time", rounds): nanoseconds for one call, a row for each job, a
## column for each round; the jobs take turns within a round. values = speed_run (s, X, jobs,
## "values"): what the jobs return, a cell for each, outputs x states. The driver is pinned to one
## processor. The rounds are shared out to three runs with new copies of the libraries: now and then
## a file lies so in memory that its code takes twice the time, and a copy of it does not.

function result = speed_run (s, X, jobs, what, rounds)
  here = fileparts (mfilename ("fullpath"));
  driver = fullfile (fileparts (s.folder), "driver");
  if (! exist (driver, "file") || stat (driver).mtime < stat (fullfile (here, "driver.c")).mtime)
    speed_cpu (sprintf ("gcc -O3 -march=native '%s' -o '%s' -ldl -lm", ...
                        fullfile (here, "driver.c"), driver));
  end
  write (fullfile (s.folder, "states.bin"), @(f) fwrite (f, X, "double"));
  if (strcmp (what, "time"))
    result = [];
    for k = 1:3
      result = [result, str2num(driven (s, size (X, 1), driver, copied (s, jobs), ...
                                        sprintf ("time %d", ceil (rounds / 3))))];
    end
    return;
  end
  driven (s, size (X, 1), driver, jobs, "values out.bin");
  file = fopen (fullfile (s.folder, "out.bin"), "rb");
  result = arrayfun (@(j) fread (file, [j.outputs, size(X, 3)], "double"), jobs, ...
                     "UniformOutput", false);
  fclose (file);
end

## the jobs with copies of their libraries
function jobs = copied (s, jobs)
  folder = fullfile (s.folder, "copies");
  confirm_recursive_rmdir (false, "local");
  [~, ~] = rmdir (folder, "s");
  [~, ~] = mkdir (folder);
  names = unique ({jobs.library});
  for k = find (! strcmp (names, "-"))
    copy = fullfile (folder, sprintf ("%d.so", k));
    copyfile (names{k}, copy);
    [jobs(strcmp ({jobs.library}, names{k})).library] = deal (copy);
  end
end

## what the driver prints
function text = driven (s, n, driver, jobs, task)
  write (fullfile (s.folder, "jobs.txt"), ...
         @(f) arrayfun (@(j) fprintf (f, "%s %s %s %d\n", j.library, j.start, j.symbol, ...
                                      j.outputs), jobs, "UniformOutput", false));
  pin = "";
  if (system ("taskset -c 0 true 2>/dev/null") == 0)
    pin = "taskset -c 0 ";
  end
  [status, text] = system (sprintf ("cd '%s' && %s'%s' states.bin %d jobs.txt %s 2>driver.log", ...
                                    s.folder, pin, driver, n, task));
  if (status != 0)
    error ("bench: the driver failed on %s:\n%s", s.name, ...
           fileread (fullfile (s.folder, "driver.log")));
  end
end

function write (name, act)
  file = fopen (name, "wb");
  act (file);
  fclose (file);
end
