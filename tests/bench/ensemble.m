## ensemble.m: the bench of many runs, called by `make bench-ensemble`. Writes ensemble.md beside
## itself.
##
## Arms, a chain of four rods, a slider-crank with its motor: runs of 1 s from scattered starts,
## three parameters of each run off by up to 1 percent. In lanes beside a compiled loop of single
## runs, one thread, the same tolerance; two threads beside one, and beside two processes of Octave
## with one thread each at the same time; what Octave adds to a run, and to a call of 20 runs. Times
## alternate, the least of many counts. Errors: the largest of a coordinate at the end beside dp853
## at rtol = 1e-13.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
out = fullfile (here, "out", "ensemble");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:stiff");

## the scene of a file with the request lanes
function m = scene_of (root, out, name, file)
  copy = fullfile (out, [name ".mac"]);
  f = fopen (copy, "w");
  fprintf (f, "load(\"%s\")$\nrequests : [all, lanes]$\n", fullfile (root, file));
  fclose (f);
  gsmbp_derive (copy, out);
  m = gsmbp_build (name, "directory", out);
end

## what differs from run to run
function o = rows_of (m, n, scatter)
  rand ("twister", 3);
  half = @(k) 2 * rand (n, k) - 1;
  names = fieldnames (m.par)(end-2:end)';
  o = {"parameters", struct(), "starts", m.initial(:)' + scatter * half(m.sizes.nx)};
  for name = names
    o{2}.(name{1}) = m.par.(name{1}) * (1 + 0.01 * half (1));
  end
end

## processes at a time, each with these runs by so many threads: median of the times of a count
## [s], in seconds in which all are at it
function time_ = by_processes (root, m, o, processes, threads)
  here = tempname ();
  file = [here ".mat"];
  directory = fullfile (root, "tests", "bench", "out", "ensemble");
  save ("-binary", file, "o", "root", "directory");
  script = [here ".m"];
  f = fopen (script, "w");
  fprintf (f, ["load ('%s'); addpath (fullfile (root, 'octave')); warning ('off', 'all');\n" ...
               "m = gsmbp_build ('%s', 'directory', directory);\n" ...
               "all = []; k = tic ();\nwhile (toc (k) < 12)\n" ...
               "  e = gsmbp_ensemble (m, [], [0, 1], o{:}, 'threads', %d);\n" ...
               "  if (toc (k) > 3 && toc (k) < 9) all(end+1) = e.seconds; end\nend\n" ...
               "printf ('%%.9g\\n', median (all));\n"], file, m.name, threads);
  fclose (f);
  one = sprintf ("octave-cli --no-init-file '%s'", script);
  [~, text] = system ([repmat([one " & "], 1, processes) "wait"]);
  delete (file, script);
  time_ = mean (sscanf (text, "%f"));
end

## two threads of a process beside two processes of one thread, in turns, the median of three, by
## runs that take about a second, beside which what Octave does between is little
function beside = threads_beside (root, m, o)
  for turn = 1:3
    threads = by_processes (root, m, o, 1, 2);
    processes = by_processes (root, m, o, 2, 1);
    beside(turn) = processes / 2 / threads;   # twice the runs in that time
  end
  beside = median (beside);
end

## least times [s] of one by one, in lanes, in lanes by two threads, of Octave beside lanes, and of
## Octave for 20 runs
function [least, e, f] = timed (m, o)
  few = o;
  few{2} = structfun (@(x) x(1:20), o{2}, "UniformOutput", false);
  few{4} = o{4}(1:20,:);
  least = Inf (1, 5);
  started = tic ();
  do
    e = gsmbp_ensemble (m, [], [0, 1], o{:}, "threads", 1, "lanes", false);
    whole = tic ();
    f = gsmbp_ensemble (m, [], [0, 1], o{:}, "threads", 1);
    octave = toc (whole) - f.seconds;
    g = gsmbp_ensemble (m, [], [0, 1], o{:}, "threads", 2);
    whole = tic ();
    h = gsmbp_ensemble (m, [], [0, 1], few{:}, "threads", 1);
    call = toc (whole) - h.seconds;
    least = min (least, [e.seconds, f.seconds, g.seconds, octave, call]);
  until (toc (started) > 15)
  if (! (f.lanes && all (e.ok) && all (f.ok) && isequal (f.x, g.x)))
    error ("%s: runs that failed, or differ by threads", m.name);
  end
end

function text = row_of (root, out, name, file, method, scatter, given)
  n = 2000;
  m = scene_of (root, out, name, file);
  o = [rows_of(m, n, scatter), given, {"method"}, method];
  [least, e, f] = timed (m, o);
  beside = threads_beside (root, m, [rows_of(m, 20000, scatter), given, {"method"}, method]);
  some = 1:100;
  o{2} = structfun (@(x) x(some), o{2}, "UniformOutput", false);
  o{4} = o{4}(some,:);
  k = find (strcmp (o, "method"), 1);
  best = gsmbp_ensemble (m, [], [0, 1], o{1:k-1}, "rtol", 1e-13, "atol", 1e-14);
  q = 1:m.sizes.nq;
  off = @(r) max (abs (r.final(some,q) - best.final(:,q))(:));
  least(4) = (least(4) - least(5)) * n / (n - 20);
  call = 1e3 * least(5);
  least *= 1e6 / n;
  text = sprintf (["| %s | %s | %.2f | %.2f | %.2f | %.1e | %.1e | %.2f | %.2f | %.1f | " ...
                   "%.0f |\n"], name, method{1}, least(1), least(2), least(1) / least(2), ...
                  off (e), off (f), least(2) / least(3), beside, least(4), call);
  printf ("%s", text);
end

systems = fullfile ("tests", "bench", "systems");
crank = fullfile ("examples", "slider_crank", "slider_crank.mac");
arm = fullfile ("examples", "puma560", "puma560.mac");
puma = {"input", [10, 20, 30]};
slider = {"input", 24, "start", "project"};
dp853 = {"dp853", "rtol", 1e-8};
rows = {"puma6", fullfile(systems, "puma6.mac"), dp853, 0.3, {}
        "puma6", fullfile(systems, "puma6.mac"), {"rk4", "step", 0.01}, 0.3, {}
        "pend4", fullfile(systems, "pend4.mac"), dp853, 0.3, {}
        "pend4", fullfile(systems, "pend4.mac"), {"rk4", "step", 0.005}, 0.3, {}
        "puma560", arm, dp853, 0.3, puma
        "puma560", arm, {"rk4", "step", 0.002}, 0.3, puma
        "slider_crank", crank, dp853, 0, slider
        "slider_crank", crank, {"rk4", "step", 0.002}, 0, slider};
text = ["| scene | method | one by one, us | in lanes, us | ratio | error one by one | " ...
        "error in lanes | two threads | threads beside processes | Octave a run, us | " ...
        "Octave a call, ms |\n|---|---|---|---|---|---|---|---|---|---|---|\n"];
for row = rows'
  text = [text, row_of(root, out, row{[1, 2, 3, 4, 5]})];
end
f = fopen (fullfile (here, "ensemble.md"), "w");
fprintf (f, ["# Many runs of 1 s, times of one run\n\nMade by `make bench-ensemble`; see " ...
             "tests/bench/ensemble.m.\n\n%s"], text);
fclose (f);
