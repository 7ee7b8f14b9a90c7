## devices.m: the bench of the devices, called by `make bench-devices`. Writes devices.md and
## devices.json beside itself.
##
## The PUMA with motors of 0.1 mH, full and with the variants that gsmbp_choose takes, on the same
## voltages: time against error by explicit and stiff integration; then every example on the motion
## of its own driver (tests/octave/example_motion.m): how much faster than real time it runs at the
## tolerance that passes its energy audit; and its global error by every way that applies
## (tests/octave/global_errors.m).

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
addpath (fullfile (root, "tests", "octave"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:stiff");
warning ("off", "gsmbp:angles");
warning ("off", "gsmbp:singular");
## run.m of an example has the name of a function of Octave
warning ("off", "Octave:shadowed-function");
for name = {"stewart", "welding_arm", "scara"}
  addpath (fullfile (root, "examples", name{1}));
end

function m = scene_of (root, out, file)
  [~, name] = fileparts (file);
  [status, text] = system (sprintf ("%s %s %s 2>&1", fullfile (root, "share", "make", "derive"), ...
                                    fullfile (root, file), out));
  if (status != 0)
    error ("bench-devices: %s does not derive: %s", file, text);
  end
  m = gsmbp_build (name, "directory", out);
end

## shortest time of at least three runs and half a second, and the run
function [seconds, r] = timed (run)
  seconds = Inf;
  started = tic ();
  k = 0;
  while (k < 3 || toc (started) < 0.5)
    r = run ();
    seconds = min (seconds, r.stats.seconds);
    k++;
  end
end

## The ways to integrate a scene: method, options, words
function ways = ways_of (m)
  ways = {"dp853", {}, "dp853"; "radau", {}, "radau"; "cvode", {}, "cvode"};
  if (m.sizes.nlam > 0 && m.mobility.rows == m.mobility.rank)
    ways(end+1,:) = {"dp853", {"loops", "baumgarte", "drift", false}, ...
                     "dp853, Baumgarte, drift not watched"};
  end
end

## An example on its motion: the fastest way, each at its largest tolerance with an energy audit
## below 1e-8 of what passed; where none is, as in reduced variants that keep the balance only to
## their order, at the largest tolerance within a tenth of the least audit.
function best = example_run (name, build)
  [m, x0, t, options, what] = example_motion (name, build);
  best = struct ("what", what, "way", "none", "rtol", NaN, "audit", NaN, "seconds", Inf, ...
                 "duration", t(end));
  for way = ways_of (m)'
    tried = [];
    for rtol = 10 .^ -(4:0.5:12)
      run = @(options) gsmbp_simulate (m, x0, t, options{:}, way{2}{:}, "method", way{1}, ...
          "rtol", rtol);
      [one, info] = run (options);
      tried(end+1,:) = [rtol, merge(info == 0, one.audit.error, NaN)];
      if (tried(end,2) < 1e-8)
        break;
      end
    end
    if (all (isnan (tried(:,2))))
      continue;
    end
    k = find (tried(:,2) <= max (1e-8, 1.1 * min (tried(:,2))), 1);
    [seconds, ~] = timed (@() gsmbp_simulate (m, x0, t, options{1:end-2}, way{2}{:}, "method", ...
                            way{1}, "rtol", tried(k,1)));
    passes = [tried(k,2) < 1e-8, best.audit < 1e-8];
    if (passes(1) > passes(2) || (passes(1) == passes(2) && seconds < best.seconds))
      [best.way, best.rtol, best.audit, best.seconds] = deal (way{3}, tried(k,1), tried(k,2), ...
          seconds);
    end
  end
end

## a line for each way to run an example on its motion: its global error at three tolerances
## beside the growth of perturbations; how many do not keep to the bound
function missed = error_lines (f, name, build)
  [m, x0, t, options] = example_motion (name, build);
  ways = {{"method", "dp853"}, {"method", "cvode"}};
  if (m.sizes.nlam > 0)
    for word = {"baumgarte", "partitioning", "nullspace", "svd", "kane"}
      ways{end+1} = {"method", "dp853", "loops", word{1}};
      ways{end+1} = {"method", "cvode", "loops", word{1}};
    end
  end
  [e, growth] = global_errors (m, x0, t, options(1:end-2), ways, 10 .^ [-6, -8, -10]);
  missed = 0;
  for k = 1:numel (ways)
    bound = 100 * max (1, growth);
    holds = all (e(k,:) <= bound);
    missed += ! holds;
    fprintf (f, "| %s | %s | %s | %s | %s |\n", name, strjoin (ways{k}(2:2:end), ", "),
             strjoin (arrayfun (@(x) sprintf ("%.2g", x), growth, "UniformOutput", false), ", "),
             strjoin (arrayfun (@(x) sprintf ("%.2g", x), e(k,:), "UniformOutput", false), ", "),
             {"no", "yes"}{1 + holds});
  end
end

[full, less, truth] = choose_runs (scene_of (root, out, "tests/scenes/choose_full.mac"), ...
                                   scene_of (root, out, "tests/scenes/choose_less.mac"));
results = struct ("side", {}, "rtol", {}, "error", {}, "milliseconds", {}, "calls", {});
sides = {"full, dp853", full, "dp853"; "full, cvode", full, "cvode"; "full, radau", full, ...
         "radau"; "chosen (qs1), dp853", ...
         less, "dp853"};
for s = 1:rows (sides)
  for rtol = 10 .^ -(2:10)
    [seconds, r] = timed (@() sides{s,2} (rtol, sides{s,3}));
    results(end+1) = struct ("side", sides{s,1}, "rtol", rtol, "error", ...
                             max (max (abs (r.x(:,1:3) - truth))), "milliseconds", ...
                             1e3 * seconds, "calls", r.stats.calls);
  end
end

## the cheapest run of each side within an accuracy
f = fopen (fullfile (here, "devices.md.new"), "w");
fprintf (f, ...
         ["# Devices: speed against error\n\nPUMA 560 of the example, motors of 0.1 " ...
          "mH (electrical time 63 us), one second of its quintic on the voltages of " ...
          "the full motors; error: largest of the three\n"]);
fprintf (f, ...
         ["angles at 21 times against the full model at rtol 1e-11. Least time of " ...
          "the runs within an accuracy.\n\n| accuracy [rad] | model, method | rtol | " ...
          "error [rad] | ms | calls | times as long as the chosen " ...
          "|\n|---|---|---|---|---|---|---|\n"]);
for accuracy = [1e-4, 1e-6, 1e-8]
  best = struct ([]);
  for s = 1:rows (sides)
    mine = results(strcmp ({results.side}, sides{s,1}) & [results.error] <= accuracy);
    if (! isempty (mine))
      [~, k] = min ([mine.milliseconds]);
      best = [best, mine(k)];
    end
  end
  chosen = best(strcmp ({best.side}, "chosen (qs1), dp853")).milliseconds;
  for b = best
    fprintf (f, "| %.0e | %s | %.0e | %.1e | %.3f | %d | %.1f |\n", accuracy, b.side, b.rtol, ...
             b.error, b.milliseconds, b.calls, b.milliseconds / chosen);
  end
end
fprintf (f, ...
         ["\n## Every example on the motion of its driver\n\nThe fastest way at the " ...
          "largest tolerance whose energy audit is below 1e-8 of the energy that " ...
          "passed (what came in and was lost, what is\n"]);
fprintf (f, ...
         ["stored, or the swing of the kinetic energy, whichever is most); the time " ...
          "is that of the run alone. The crane's variant pl keeps its balance to its " ...
          "order only.\n\n| scene | motion | method | rtol | audit | times faster " ...
          "than real time |\n|---|---|---|---|---|---|\n"]);
build = @(name) gsmbp_build (name, "directory", out);
for file = glob (fullfile (root, "examples", "*", "*.mac"))'
  [folder, name] = fileparts (file{1});
  [~, folder] = fileparts (folder);
  try
    scene_of (root, out, fullfile ("examples", folder, [name ".mac"]));
    b = example_run (name, build);
    fprintf (f, "| %s | %s | %s | %.0e | %.1e | %.0f |\n", name, b.what, b.way, b.rtol, b.audit, ...
             b.duration / b.seconds);
  catch err
    fprintf (f, "| %s | - | - | - | %s | - |\n", name, strrep (err.message, "\n", " "));
  end
  fflush (f);
end
fprintf (f, ...
         ["\n## Global error\n\nThe same motions. Growth: how much a perturbation of " ...
          "the start as large as the tolerance grows at most. Error: the largest of\n"]);
fprintf (f, ...
         ["all states at all times beside dp853 at rtol 1e-13, over the tolerance. " ...
          "Three numbers each: rtol 1e-6, 1e-8, 1e-10. The bound is\n100 times the " ...
          "tolerance times max(1, growth).\n\n"]);
fprintf (f, ...
         ["| scene | way | growth | error over tolerance | within the bound " ...
          "|\n|---|---|---|---|---|\n"]);
missed = 0;
for file = glob (fullfile (root, "examples", "*", "*.mac"))'
  [~, name] = fileparts (file{1});
  try
    missed += error_lines (f, name, build);
  catch err
    missed++;
    fprintf (f, "| %s | - | - | %s | no |\n", name, strrep (err.message, "\n", " "));
  end
  fflush (f);
end
fprintf (f, "\nRows that are not within the bound: %d.\n", missed);
fclose (f);
rename (fullfile (here, "devices.md.new"), fullfile (here, "devices.md"));
g = fopen (fullfile (here, "devices.json"), "w");
fputs (g, [jsonencode(results) "\n"]);
fclose (g);
type (fullfile (here, "devices.md"));
