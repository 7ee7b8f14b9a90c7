## text = peers_rollout (s, peers): 500 runs from scattered starts, by mujoco.rollout with RK4 and
## by gsmbp_ensemble in lanes with RK4 and dp853, one thread each: at each step of MuJoCo's the
## fastest of ours whose largest error is no larger, and RK4 with the same step. Both integrate the
## same equations by the same formulas, so that these errors differ by rounding alone: what is
## larger by less than a thousandth is not larger. Three turns, the least time of all counts.

function text = peers_rollout (s, peers)
  rand ("twister", 3);
  x = s.x0 + 0.3 * (2 * rand (500, s.m.sizes.nx) - 1);
  q = 1:s.m.sizes.nq;
  starts = fullfile (s.folder, "starts.txt");
  f = fopen (starts, "w");
  fprintf (f, [repmat("%.17g ", 1, columns (x)) "\n"], x');
  fclose (f);
  best = gsmbp_ensemble (s.m, [], [0, s.end], "starts", x, "rtol", 1e-13, "atol", 1e-14);
  steps = [0.02, 0.01, 0.005, 0.002, 0.001];
  theirs = Inf (size (steps));
  w = [];
  for turn = 1:3
    [seconds, ends] = rollouts (s, peers, starts, steps);
    if (isempty (seconds))
      text = "\n* mujoco.rollout is not here\n";
      return;
    end
    theirs = min (theirs, seconds);
    w = ours (w, s, x, best.final(:,q), steps);
  end
  miss = cellfun (@(last) max (max (abs (last - best.final(:,q)))), ends);
  text = ["\n| mujoco.rollout, step | error | us a run | GSMBP in lanes, us | by | ratio " ...
          "| rk4, same step, us | error | ratio |\n|---|---|---|---|---|---|---|---|---|\n"];
  for k = 1:numel (steps)
    text = [text, line(w, steps(k), miss(k), theirs(k))];
  end
end

## a line of the table: their step, its error and seconds
function text = line (w, step, miss, theirs)
  fit = w([w.error] <= 1.001 * miss);
  same = w(strcmp ({w.method}, "rk4") & [w.setting] == step);
  text = sprintf ("| %g | %.1e | %.1f |", step, miss, 1e6 * theirs);
  if (isempty (fit))
    text = [text " - | - | - |"];
  else
    [least, j] = min ([fit.seconds]);
    text = [text, sprintf(" %.2f | %s %.2g | %.1f |", 1e6 * least, fit(j).method, ...
                          fit(j).setting, theirs / least)];
  end
  text = [text, sprintf(" %.2f | %.1e | %.1f |", 1e6 * same.seconds, same.error, ...
                        theirs / same.seconds), "\n"];
end

## their seconds a run and coordinates at the end, for each step; [] where it fails
function [seconds, ends] = rollouts (s, peers, starts, steps)
  [seconds, ends] = deal ([], {});
  for step = steps
    command = sprintf ("cd '%s' && '%s' -W ignore rollout.py '%s' '%s' %g 2>/dev/null", ...
                       fileparts (mfilename ("fullpath")), ...
                       fullfile (peers, "venv", "bin", "python"), s.folder, starts, step);
    [status, told] = system (command);
    if (status != 0)
      [seconds, ends] = deal ([], {});
      return;
    end
    seconds(end+1) = str2double (told);
    ends{end+1} = load (fullfile (s.folder, "rollout.txt"));
  end
end

## seconds a run, largest error; the least of those of W, of an earlier turn, and of three runs more
function w = ours (w, s, x, exact, steps)
  before = w;
  w = struct ("method", {}, "setting", {}, "seconds", {}, "error", {});
  steps = unique ([steps, 1 ./ round(10 .^ (1.5:0.05:3.2))]);
  for one = {"rk4", "step", steps; "dp853", "rtol", 10 .^ -(1:0.25:10)}'
    for value = one{3}
      least = Inf;
      for k = 1:3
        e = gsmbp_ensemble (s.m, [], [0, s.end], "starts", x, "method", one{1}, one{2}, value, ...
                            "threads", 1);
        least = min (least, e.seconds / rows (x));
      end
      if (! (e.lanes && all (e.ok)))
        continue;
      end
      w(end+1) = struct ("method", one{1}, "setting", value, "seconds", least, "error", ...
                         max (max (abs (e.final(:,1:columns (exact)) - exact))));
      if (! isempty (before))
        w(end).seconds = min (least, before(numel (w)).seconds);
      end
    end
  end
end
