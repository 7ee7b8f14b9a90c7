## sweep.m: the bench of a sweep, called by `make bench-sweep`. Writes sweep.md beside itself.
##
## 1e5 runs (GSMBP_RUNS: so many) of the slider-crank with its motor over 0.2 s, 11 times, two
## parameters, with a file: the whole call, plan, chunks on disk, table in HDF5, statistics, beside
## the integration alone, on one thread and on two; what memory they add at most, beside a tenth of
## the runs.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));

## the most memory that the process had so far [MB]
function mb = peak ()
  said = regexp (fileread ("/proc/self/status"), 'VmHWM:\s+(\d+)', "tokens");
  mb = str2double (said{1}{1}) / 1024;
end

function [whole, alone, mb] = swept (m, n, threads)
  file = [tempname() ".h5"];
  tidy = onCleanup (@() delete (file));
  vary = struct ("la", [4e-3 6e-3], "km", {{"normal", 0.228, 0.005}});
  whole = tic ();
  w = gsmbp_sweep (m, m.initial, linspace (0, 0.2, 11), "input", 12, "vary", vary, "runs", n, ...
                   "keep", {["peak " m.states{4}], ["rms " m.states{3}]}, "file", file, ...
                   "threads", threads);
  whole = toc (whole);
  alone = w.seconds;
  mb = peak ();
  if (! all (w.ok))
    error ("bench-sweep: a run failed: %s", w.reason{find (! w.ok, 1)});
  end
end

m = gsmbp_build ("slider_crank", "directory", fullfile (root, "fortran_out"));
n = str2double (getenv ("GSMBP_RUNS"));
n(isnan (n)) = 1e5;
swept (m, 64, 1);
before = peak ();
text = sprintf ("%d runs of the slider-crank with its motor, made by `make bench-sweep`.\n\n", n);
text = [text, "| runs | threads | integration [s] | whole call [s] | ratio | memory [MB] |\n" ...
        "|---|---|---|---|---|---|\n"];
for one = [n / 10, n, n; 1, 1, 2]
  [whole, alone, mb] = swept (m, one(1), one(2));
  text = [text, sprintf("| %d | %d | %.2f | %.2f | %.3f | %.0f |\n", one, alone, whole, ...
                        whole / alone, mb - before)];
end
f = fopen (fullfile (here, "sweep.md"), "w");
fputs (f, text);
fclose (f);
disp (text);
