## text = bench_text (truths, all, skipped, andrews, ladder, bricard, out): loops.md; draws its
## figures into OUT.

function text = bench_text (truths, all, skipped, andrews, ladder, bricard, out)
  text = ...
      ["# Loops: time, error, drift\n\nWritten by `make bench-loops`. Times are those of one " ...
       "run on one machine: compare ratios. Method everywhere: Dormand-Prince 8(5,3) with " ...
       "step\n" ...
    "control, rtol = atol. Error: largest deviation of a coordinate [rad, m] at the output " ...
    "times from the same Fortran in quad precision at a tolerance of\n" ...
    "1e-18. Drift: largest constraint (m or of unit axes) and its rate after any step. " ...
    "Energy: largest change beside the energy exchanged between kinetic and\n" ...
    "potential, where there is neither supply nor loss.\n\n"];
  if (! isempty (all))
    text = [text, "## Every mechanism, every way\n\n", mechanisms(truths, all), ...
            figure_of(truths, all, out), choose(truths, all, ladder)];
  end
  if (! isempty (skipped))
    text = [text, "Not run:\n\n", sprintf("* %s\n", skipped{:}), "\n"];
  end
  if (! isempty (andrews.own))
    text = [text, andrews_text(andrews, out)];
  end
  if (! isempty (ladder))
    text = [text, ladder_text(ladder)];
  end
  if (! isempty (bricard))
    text = [text, bricard_text(bricard)];
  end
end

## -------------------------------------------------------------------------------------- mechanisms

function text = mechanisms (truths, all)
  text = "";
  for t = truths
    of = all(strcmp ({all.mechanism}, t.name));
    text = [text, ...
            sprintf("### %s\n\n%s; %d coordinates, %d constraint rows, %g s. %s\n\n", t.name, ...
                    capital (t.what), t.coordinates, t.rows, t.span, known (t))];
    text = [text, ...
            ["| way | ms for 1 s, rtol 1e-8 | calls | error | drift | its rate | energy | ms " ...
             "for 1 s, error below 1e-8 | failures of 5 " ...
             "|\n|---|---|---|---|---|---|---|---|---|\n"]];
    for way = bench_ways ()
      w = of(strcmp ({of.way}, way{1}));
      r = w(abs ([w.rtol] - 1e-8) < 1e-12);
      text = ...
          [text, sprintf("| %s | %s | %s | %s | %s | %s | %s | %s | %s |\n", way{1}, ...
                         ms(r.seconds), whole(r.calls), e1(r.error), e1(r.phi), e1(r.phidot), ...
                             e1(r.energy),
                            ms (to_error (w, 1e-8)), failures (w))];
    end
    text = [text, "\n"];
  end
end

function text = known (t)
  if (! isfinite (t.known))
    text = "No quad-precision run succeeded: no errors.";
  else
    text = sprintf ("Reference by %s, itself known to %.0e.", t.way, max (t.known, 1e-16));
  end
end

## the least time of the runs whose error is below LIMIT
function seconds = to_error (w, limit)
  seconds = min ([w([w.error] < limit).seconds, Inf]);
  if (! isfinite (seconds))
    seconds = NaN;
  end
end

function text = failures (w)
  bad = w([w.info] != 0);
  if (numel (bad) == numel (w) && all ([bad.info] == -1))
    text = "not available";
  elseif (isempty (bad))
    text = "0";
  else
    text = sprintf ("%d (%s)", numel (bad), bad(end).failure);
  end
end

## ------------------------------------------------------------------------------------------ figure

function text = figure_of (truths, all, out)
  panels = struct ([]);
  [words, colors] = bench_ways ();
  for t = truths
    curves = struct ([]);
    for k = 1:numel (words)
      w = all(strcmp ({all.mechanism}, t.name) & strcmp ({all.way}, words{k}));
      curves = [curves, ...
                struct("name", words{k}, "color", colors{k}, "x", [w.seconds], "y", [w.error])];
    end
    panels = [panels, struct("title", t.name, "curves", curves)];
  end
  bench_figure (fullfile (out, "loops.png"), panels, "time for 1 s [s]");
  text = "![speed against error](out/loops.png)\n\n";
end

## ----------------------------------------------------------------------------- what to choose when

function text = choose (truths, all, ladder)
  s = summary (truths, all);
  text = ...
      ["## What to choose when\n\nTime: to an error below 1e-8, beside that of projection on " ...
       "the same mechanism. Wrong: runs at rtol 1e-8 or less that ended with an error above " ...
       "1e-3.\n\n" ...
          "| way | time beside projection: median (range) | fastest in | stopped | wrong | " ...
          "worst drift | worst rate |\n|---|---|---|---|---|---|---|\n"];
  for w = s
    text = [text, ...
            sprintf("| %s | %s | %s | %d of %d | %s | %s | %s |\n", w.way, spread(w.ratio), ...
                    strjoin (w.fastest, ", "), w.failed, w.runs, strjoin (w.wrong, ", "), ...
                    e1(w.phi), e1(w.phidot))];
  end
  text = [text, "\n", advice(s, ladder), "\n"];
end

function s = summary (truths, all)
  s = struct ([]);
  words = bench_ways ();
  time = NaN (numel (words), numel (truths));
  for k = 1:numel (words)
    for j = 1:numel (truths)
      time(k,j) = to_error (all(strcmp ({all.way}, words{k}) & strcmp ({all.mechanism}, ...
                                  truths(j).name)), 1e-8);
    end
  end
  for k = 1:numel (words)
    w = all(strcmp ({all.way}, words{k}) & [all.info] != -1);
    ratio = time(k,:) ./ time(1,:);
    wrong = w([w.info] == 0 & [w.error] > 1e-3 & [w.rtol] < 2e-8);
    s = [s, struct("way", words{k}, "fastest", {{truths(time(k,:) == min (time, [], ...
              1)).name}}, "ratio", ratio(isfinite (ratio)), "failed", sum ([w.info] > 0), ...
                  "runs", numel (w),
                   "wrong", {unique({wrong.mechanism}, ...
                                    "stable")}, "slow", {{truths(ratio > 10).name}}, "phi", ...
                                        top([w.phi]), "phidot", top([w.phidot]))];
  end
end

## what the table says, in words
function text = advice (s, ladder)
  by = @(way) s(strcmp ({s.way}, way));
  p = by ("projection");
  text = ...
      sprintf (["* **projection**, the default: after every step the constraints hold to %s, " ...
                "their rates to %s%s.%s\n"], e1 (p.phi), e1 (p.phidot), trouble (p),
                  {"", " Start with it."}{1 + (p.failed == 0 && isempty (p.wrong))});
  b = by ("baumgarte");
  if (! isempty (b.ratio))
    text = ...
        [text, sprintf(["* **baumgarte**: %.2f times the time of projection (median)%s; the " ...
                        "loops open by up to %s, with rates up to %s%s."], median (b.ratio), ...
                            slow (b), e1 (b.phi),
                          e1 (b.phidot), trouble (b))];
    avoid = unique ([b.slow, b.wrong], "stable");
    if (median (b.ratio) < 0.95)
      text = [text, " Take it where time counts more than drift"];
      if (! isempty (avoid))
        text = [text, sprintf(", and not for mechanisms such as %s", strjoin (avoid, ", "))];
      end
      text = [text, "."];
    end
    text = [text, "\n"];
  end
  q = by ("partitioning");
  if (! isempty (q.ratio))
    text = ...
        [text, sprintf(["* **partitioning**: %.2f times the time of projection (median)%s%s; " ...
                        "every call of the right-hand side is on the constraints%s.%s\n"], ...
                            median (q.ratio),
                          but (q.fastest), slow (q), trouble (q), ladders (ladder))];
  end
  for way = {"nullspace", "svd", "kane"}
    w = by (way{1});
    if (! isempty (w.ratio))
      text = [text, ...
              sprintf("* **%s**: %.2f times the time of projection (median)%s%s%s.\n", way{1}, ...
                      median (w.ratio), but (w.fastest), slow (w), trouble (w))];
    end
  end
end

function text = but (names)
  text = "";
  if (! isempty (names))
    text = [", but the fastest for " strjoin(names, ", ")];
  end
end

function text = slow (w)
  text = "";
  if (! isempty (w.slow))
    text = sprintf (", above ten times for %s", strjoin (w.slow, ", "));
  end
end

function text = trouble (w)
  text = "";
  if (w.failed > 0)
    text = sprintf ("; %d of %d runs stopped", w.failed, w.runs);
  end
  if (! isempty (w.wrong))
    text = [text, "; wrong for " strjoin(w.wrong, ", ")];
  end
end

function text = ladders (ladder)
  text = "";
  if (! isempty (ladder))
    good = @(way) sum ([ladder(strcmp ({ladder.way}, way)).loss] < 1e-5);
    [q, p] = deal (good ("partitioning"), good ("projection"));
    text = ...
        sprintf (" Of the %d ladder runs of each way below %d went right, by projection %d%s.", ...
                 numel (ladder) / 2, q, p,
                    {"", ": take it through singular positions"}{1 + (q > p)});
  end
end

## ----------------------------------------------------------------------------------------- Andrews

function text = andrews_text (a, out)
  own = best (a.own, 1e-8);
  text = ...
      sprintf (["## Andrews' squeezer against SUNDIALS IDA\n\nSeven angles at t = %g s, the " ...
                "error against the 27 digits of `tests/data/04_andrews_squeezer`; time of the " ...
                "whole run, best of several. Both\n" ...
    "sides call the same emitted Fortran, compiled alike; tolerances are relative, absolute " ...
    "rtol rad and 1000 rtol rad/s. IDA (BDF, order up to 5, dense LU,\n" ...
    "multipliers out of the error test) works on index-reduced equations with exact Jacobian: " ...
    "`ode` x' = f(x); `index1` and `index2`, the constraints in accelerations\n" ...
    "and in speeds; `ggl`, the stabilized index 2 of Gear, Gupta and Leimkuhler. Five " ...
    "tolerances each.\n\n| | rtol | ms | error | calls | steps |\n|---|---|---|---|---|---|\n"], ...
        a.end);
  for r = [a.own, a.ida]
    text = [text, ...
            sprintf("| %s | %.1e | %s | %s | %s | %s |\n", label(r, a), r.rtol, ms(r.seconds), ...
                    e1(r.error), whole(r.calls), whole(r.steps))];
  end
  text = [text, "\n"];
  if (isempty (own))
    text = [text, "No run of GSMBP came below 1e-8.\n\n"];
  else
    text = [text, ...
            sprintf("Error below 1e-8: GSMBP (%s, rtol %.1e) %s ms, error %s.", own.way, ...
                    own.rtol, ms (own.seconds), e1 (own.error))];
    if (isempty (a.ida))
      text = [text, " SUNDIALS is not installed: no comparison.\n\n"];
    else
      ida = best (a.ida, 1e-8);
      usual = best (a.own(strcmp ({a.own.way}, "projection")), 1e-8);
      if (isempty (ida))
        text = [text, " No run of IDA came below 1e-8.\n\n"];
      else
        text = [text, ...
                sprintf(" IDA (%s, rtol %.1e) %s ms, error %s: %.1f times as long", ...
                        regexprep (ida.way, "s$", ""), ida.rtol, ms (ida.seconds), ...
                        e1 (ida.error), ida.seconds / own.seconds)];
        if (! isempty (usual))
          text = [text, ...
                  sprintf(["; %.1f times as long as the default (projection, rtol %.1e, %s " ...
                           "ms, error " ...
                           "%s)"], ida.seconds / usual.seconds, usual.rtol, ms (usual.seconds), ...
                          e1 (usual.error))];
        end
        text = [text, ".\n\n"];
      end
    end
  end
  text = [text, andrews_figure(a, out)];
end

function text = label (r, a)
  text = r.way;
  if (any (arrayfun (@(i) isequaln (i, r), a.ida)))
    text = ["IDA " regexprep(r.way, "s$", "")];
  end
end

function r = best (runs, limit)
  runs = runs([runs.error] < limit);
  [~, k] = min ([runs.seconds]);
  r = runs(k);
end

function text = andrews_figure (a, out)
  [words, colors] = bench_ways ();
  curves = struct ([]);
  for way = unique ({a.own.way}, "stable")
    w = a.own(strcmp ({a.own.way}, way{1}));
    curves = [curves, ...
              struct("name", way{1}, "color", colors{strcmp(words, way{1})}, "x", [w.seconds], ...
                     "y", [w.error])];
  end
  gray = {"#999999", "#666666", "#333333", "#000000"};
  if (! isempty (a.ida))
    for way = unique ({a.ida.way}, "stable")
      w = a.ida(strcmp ({a.ida.way}, way{1}));
      curves = [curves, ...
                struct("name", ["IDA " regexprep(way{1}, "s$", "")], "color", gray{1}, "x", ...
                       [w.seconds], "y", [w.error])];
      gray(1) = [];
    end
  end
  bench_figure (fullfile (out, "andrews.png"), ...
                struct ("title", "Andrews' squeezer, 0.03 s", "curves", curves), ...
                "time of the run [s]");
  text = "![Andrews' squeezer: GSMBP and IDA](out/andrews.png)\n\n";
end

## --------------------------------------------------------------------------------- ladder, Bricard

function text = ladder_text (l)
  text = ...
      ["## Ladder of four-bars through its singular positions\n\nN loops, 2N + 1 slender rods " ...
       "of 1 m and 1 kg, cranks started upright, tips at 1 m/s, 10 s under gravity. Twice a " ...
       "turn all rods lie in one line and every\n" ...
    "loop could go on as a parallelogram or crossed. Energy: kinetic and potential (heights " ...
    "from the ground), its largest change beside its value at the start.\n\n" ...
    "| N | way | rtol | right-hand side | projection | s for 10 s | calls | passed | energy | " ...
    "drift | cranks apart [rad] | outcome |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n"];
  for r = l
    text = ...
        [text, sprintf(["| %d | %s | %.0e | %.2f us | %.1f us | %.3f | %s | %d | %s | %s | %s " ...
                        "| %s |\n"], r.loops, r.way, r.rtol, 1e6 ...
        * r.rhs, 1e6 * r.prj, 10 * r.seconds, whole(r.calls), r.passed, e1(r.loss), e1(r.phi),
                          e1 (r.apart), outcome (r))];
  end
  big = l([l.loops] == max ([l.loops]));
  right = sum ([big.loss] < 1e-5);
  small = l([l.loops] == min ([l.loops]))(1);
  text = ...
      [text, sprintf(["\nN = %d: energy within 1e-5 of the total of %.0f J in %d of %d runs; " ...
                      "of the others %s.\nFrom N = %d to %d, %.1f times as many, the " ...
                      "right-hand\n" ...
    "side takes %.1f times as long, a projection %.1f times.\n\n"], big(1).loops, big(1).total, ...
        right, numel (big), wrong (big), small.loops, big(1).loops,
    big(1).loops / small.loops, big(1).rhs / small.rhs, big(1).prj / small.prj)];
end

function text = outcome (r)
  text = r.failure;
  if (isempty (text))
    text = {"energy off", "right"}{1 + (r.loss < 1e-5)};
    if (r.apart > 1e-3)
      text = "another branch";
    end
  end
end

function text = wrong (runs)
  silent = sum ([runs.info] == 0 & ! ([runs.loss] < 1e-5) & [runs.singular] == 0);
  warned = sum ([runs.info] == 0 & ! ([runs.loss] < 1e-5) & [runs.singular] > 0);
  text = sprintf ("%d stopped with a message, %d off with a warning, %d off without", ...
                  sum ([runs.info] != 0), warned, silent);
end

function text = bricard_text (b)
  text = ...
      sprintf (["## Bricard's six-bar, 10 s\n\nFive rods of 1 m and 1 kg and the ground, six " ...
                "revolute joints: five rows of which one depends on the others in every " ...
                "position that closes. %s J are exchanged.\n\n" ...
    "| way | rtol | ms for 1 s | calls | steps | rejected | energy | drift [m] | its rate | " ...
    "outcome |\n|---|---|---|---|---|---|---|---|---|---|\n"], sprintf ("%.3g", ...
        top ([b.exchanged])));
  for r = b
    text = [text, ...
            sprintf("| %s | %.0e | %s | %s | %s | %s | %s | %s | %s | %s |\n", r.way, r.rtol, ...
                    ms(r.seconds), whole(r.calls), whole(r.steps), whole(r.rejected), ...
                    e1(r.energy), e1(r.phi), e1(r.phidot), r.failure)];
  end
  good = b([b.energy] < 1e-8 & [b.phi] < 1e-10);
  text = [text, ...
          sprintf(["\nEnergy within 1e-8 of what is exchanged and drift below 1e-10 m: %d of " ...
                   "%d runs, the fastest %s.\n"], numel (good), numel (b), named (good))];
end

function text = named (good)
  text = "-";
  if (! isempty (good))
    [~, k] = min ([good.seconds]);
    text = sprintf ("%s at rtol %.0e (%s ms for 1 s)", good(k).way, good(k).rtol, ...
                    ms (good(k).seconds));
  end
end

## ----------------------------------------------------------------------------------------- numbers

function text = e1 (v)
  text = "-";
  if (isfinite (v))
    text = sprintf ("%.1e", v);
  end
end

function text = ms (v)
  text = "-";
  if (isfinite (v))
    text = sprintf ("%.3g", 1e3 * v);
  end
end

function text = whole (v)
  text = "-";
  if (isfinite (v))
    text = sprintf ("%d", v);
  end
end

function text = spread (v)
  text = "-";
  if (! isempty (v))
    text = sprintf ("%.2f (%.2f to %.2f)", median (v), min (v), max (v));
  end
end

function text = capital (text)
  text(1) = toupper (text(1));
end

function v = top (v)
  v = max ([v(isfinite (v)), -Inf]);
end
