## ns = speed_run (s, X, jobs, "time", rounds): nanoseconds for one call, a row for each job, a
## column for each round; the jobs take turns within a round. values = speed_run (s, X, jobs,
## "values"): what the jobs return, a cell for each, outputs x states. The driver is pinned to one
## processor.

function result = speed_run (s, X, jobs, what, rounds)
  here = fileparts (mfilename ("fullpath"));
  files = cellfun (@(f) fullfile (s.folder, f), {"states.bin", "jobs.txt", "out.bin"}, ...
                   "UniformOutput", false);
  driver = fullfile (fileparts (s.folder), "driver");
  if (! exist (driver, "file") || stat (driver).mtime < stat (fullfile (here, "driver.c")).mtime)
    speed_cpu (sprintf ("gcc -O3 -march=native '%s' -o '%s' -ldl -lm", ...
                        fullfile (here, "driver.c"), driver));
  end
  write (files{1}, @(f) fwrite (f, X, "double"));
  write (files{2}, ...
         @(f) arrayfun (@(j) fprintf (f, "%s %s %s %d\n", j.library, j.start, j.symbol, ...
                                      j.outputs), jobs, "UniformOutput", false));
  pin = "";
  if (system ("taskset -c 0 true 2>/dev/null") == 0)
    pin = "taskset -c 0 ";
  end
  last = files{3};
  if (strcmp (what, "time"))
    last = num2str (rounds);
  end
  [status, text] = system (sprintf ("cd '%s' && %s'%s' '%s' %d '%s' %s '%s' 2>driver.log", ...
                                    s.folder, pin, driver, files{1}, size (X, 1), files{2}, ...
                                    what, last));
  if (status != 0)
    error ("bench: the driver failed on %s:\n%s", s.name, ...
           fileread (fullfile (s.folder, "driver.log")));
  end
  if (strcmp (what, "time"))
    result = str2num (text);
    return;
  end
  file = fopen (files{3}, "rb");
  result = arrayfun (@(j) fread (file, [j.outputs, size(X, 3)], "double"), jobs, ...
                     "UniformOutput", false);
  fclose (file);
end

function write (name, act)
  file = fopen (name, "wb");
  act (file);
  fclose (file);
end
