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

## A second of an example's life: its planned motion by the devices' commands where they have an inverse, else a free run from its start with
## some speed. The largest tolerance at which the energy audit is below 1e-8 of what passed; sampled control as the scene has it.
function [a, seconds, rtol, method] = example_run (m)
  a = seconds = rtol = NaN;
  best = "none";
  d = m.sizes;
  x0 = m.initial;
  if (d.nlam > 0)
    x0 = m.prj (0, x0);
  end
  given = {"input", zeros(d.nv, 1)};
  if (any (strcmp (m.subroutines, "cmd")) && isempty (m.json.controllers))
    from = x0(m.actuated);
    plan = gsmbp_plan ("septic", [from, from + 0.2], [0, 1]);
    x0 = gsmbp_inverse (m, plan, 0, "guess", x0(1:d.nq)).x(1,:)';
    given = {"motion", plan};
  else
    x0(d.nq+(1:d.nu)) = 0.5;
    if (any (strcmp (m.subroutines, "prj")))
      x0 = m.prj (0, x0);
    end
  end
  for method = {"dp853", "cvode"}
    for r = 10 .^ -(4:12)
      run = @() gsmbp_simulate (m, x0, [0, 1], given{:}, "rtol", r, "audit", 1, "method", method{1});
      one = run ();
      if (one.audit.error < 1e-8)
        [t, one] = timed (run);
        if (! (t > seconds))
          [a, seconds, rtol, best] = deal (one.audit.error, t, r, method{1});
        end
        break;
      end
    end
  end
  method = best;
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
fprintf (f, "\n## One second of every example\n\nPlanned motion through the devices where they have an inverse, else a free run; the largest tolerance whose energy audit is below 1e-8 of the energy that passed, by dp853 or\n");
fprintf (f, "cvode, whichever is faster.\n\n| example | method, rtol | audit | times faster than real time |\n|---|---|---|---|\n");
for folder = dir (fullfile (root, "examples"))'
  if (! folder.isdir || folder.name(1) == ".")
    continue;
  end
  for file = glob (fullfile (root, "examples", folder.name, "*.mac"))'
    [~, name] = fileparts (file{1});
    try
      m = scene_of (root, out, fullfile ("examples", folder.name, [name ".mac"]));
      [a, seconds, rtol, method] = example_run (m);
      fprintf (f, "| %s | %s, %.0e | %.1e | %.0f |\n", name, method, rtol, a, 1 / seconds);
    catch err
      fprintf (f, "| %s | - | %s | - |\n", name, strrep (err.message, "\n", " "));
    end
    fflush (f);
  end
end
fclose (f);
rename (fullfile (here, "devices.md.new"), fullfile (here, "devices.md"));
g = fopen (fullfile (here, "devices.json"), "w");
fputs (g, [jsonencode(results) "\n"]);
fclose (g);
type (fullfile (here, "devices.md"));
