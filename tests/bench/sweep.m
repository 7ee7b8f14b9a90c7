## sweep.m: the bench of a sweep, called by `make bench-sweep`. Writes sweep.md beside itself.
##
## 1e5 runs (GSMBP_RUNS: so many) of the slider-crank with its motor over 0.2 s, 11 times, two
## parameters, with a file: the whole call, plan, chunks on disk, table in HDF5, statistics, beside
## the integration alone, on one thread and on two, and in lanes; what memory they add at most,
## beside a tenth of the runs.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
out = fullfile (here, "out");
addpath (fullfile (root, "octave"), fullfile (root, "tests", "octave"));

## the most memory that the process had so far [MB]
function mb = peak ()
  said = regexp (fileread ("/proc/self/status"), 'VmHWM:\s+(\d+)', "tokens");
  mb = str2double (said{1}{1}) / 1024;
end

function [whole, alone, mb] = swept (m, n, threads, lanes)
  file = [tempname() ".h5"];
  tidy = onCleanup (@() delete (file));
  vary = struct ("la", [4e-3 6e-3], "km", {{"normal", 0.228, 0.005}});
  whole = tic ();
  w = gsmbp_sweep (m, m.initial, linspace (0, 0.2, 11), "input", 12, "vary", vary, "runs", n, ...
                   "keep", {["peak " m.states{4}], ["rms " m.states{3}]}, "file", file, ...
                   "threads", threads, "lanes", lanes == 1);
  whole = toc (whole);
  alone = w.seconds;
  mb = peak ();
  if (! all (w.ok))
    error ("bench-sweep: a run failed: %s", w.reason{find (! w.ok, 1)});
  end
end

## the scene with the request lanes
function m = crank (root, out)
  copy = fullfile (out, "slider_crank.mac");
  f = fopen (copy, "w");
  fprintf (f, "load(\"%s\")$\nrequests : [all, lanes]$\n", ...
           fullfile (root, "examples", "slider_crank", "slider_crank.mac"));
  fclose (f);
  gsmbp_derive (copy, out);
  m = gsmbp_build ("slider_crank", "directory", out);
end

m = crank (root, out);
n = str2double (getenv ("GSMBP_RUNS"));
n(isnan (n)) = 1e5;
swept (m, 64, 1, 0);
before = peak ();
text = sprintf ("%d runs of the slider-crank with its motor, made by `make bench-sweep`.\n\n", n);
text = [text, "| runs | threads | lanes | integration [s] | whole call [s] | ratio | " ...
        "memory [MB] |\n" ...
        "|---|---|---|---|---|---|---|\n"];
for one = [n / 10, n, n, n, n; 1, 1, 2, 1, 2; 0, 0, 0, 1, 1]
  [whole, alone, mb] = swept (m, one(1), one(2), one(3));
  text = [text, sprintf("| %d | %d | %d | %.2f | %.2f | %.3f | %.0f |\n", one, alone, whole, ...
                        whole / alone, mb - before)];
end
f = fopen (fullfile (here, "sweep.md"), "w");
fputs (f, text);
fclose (f);
disp (text);
