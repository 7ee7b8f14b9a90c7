## devices.m: the bench of the devices, called by `make bench-devices`. Writes devices.md and devices.json beside itself.
##
## The PUMA with motors of 0.1 mH, full and with the variants that gsmbp_choose takes, on the same voltages: time against error by explicit and stiff
## integration; then every example with devices: how much faster than real time it runs at the tolerance that passes its energy audit.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
addpath (fullfile (root, "tests", "octave"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:stiff");

function m = scene_of (root, out, file)
  [~, name] = fileparts (file);
  [status, text] = system (sprintf ("%s %s %s 2>&1", fullfile (root, "share", "make", "derive"), fullfile (root, file), out));
  if (status != 0)
    error ("bench-devices: %s does not derive: %s", file, text);
  end
  m = gsmbp_build (name, "directory", out);
end

## shortest time of at least three runs and a quarter of a second, and the run
function [seconds, r] = timed (run)
  seconds = Inf;
  started = tic ();
  k = 0;
  while (k < 3 || toc (started) < 0.25)
    r = run ();
    seconds = min (seconds, r.stats.seconds);
    k++;
  end
end

[full, less, truth] = choose_runs (scene_of (root, out, "tests/scenes/choose_full.mac"), scene_of (root, out, "tests/scenes/choose_less.mac"));
results = struct ("side", {}, "rtol", {}, "error", {}, "milliseconds", {}, "calls", {});
sides = {"full, dp853", full, "dp853"; "full, cvode", full, "cvode"; "chosen (qs1), dp853", less, "dp853"};
for s = 1:rows (sides)
  for rtol = 10 .^ -(2:10)
    [seconds, r] = timed (@() sides{s,2} (rtol, sides{s,3}));
    results(end+1) = struct ("side", sides{s,1}, "rtol", rtol, "error", max (max (abs (r.x(:,1:3) - truth))), "milliseconds", 1e3 * seconds, "calls", r.stats.calls);
  end
end

## the cheapest run of each side within an accuracy
f = fopen (fullfile (here, "devices.md.new"), "w");
fprintf (f, "# Devices: speed against error\n\nPUMA 560 of the example, motors of 0.1 mH (electrical time 63 us), one second of its quintic on the voltages of the full motors; error: largest of the three\n");
fprintf (f, "angles at 21 times against the full model at rtol 1e-11. Least time of the runs within an accuracy.\n\n| accuracy [rad] | model, method | rtol | error [rad] | ms | calls | times as long as the chosen |\n|---|---|---|---|---|---|---|\n");
for accuracy = [1e-4, 1e-6]
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
    fprintf (f, "| %.0e | %s | %.0e | %.1e | %.3f | %d | %.1f |\n", accuracy, b.side, b.rtol, b.error, b.milliseconds, b.calls, b.milliseconds / chosen);
  end
end
fclose (f);
rename (fullfile (here, "devices.md.new"), fullfile (here, "devices.md"));
g = fopen (fullfile (here, "devices.json"), "w");
fputs (g, [jsonencode(results) "\n"]);
fclose (g);
type (fullfile (here, "devices.md"));
