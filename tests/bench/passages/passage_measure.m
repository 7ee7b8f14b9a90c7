## r = passage_measure (S, RTOL, PAIRS, SEED): the motions of passage_scene at the relative
## tolerance RTOL.  PAIRS: a row for each run, the numbers of first step and grid of passage_draw.
## r: energy (largest relative change, a number a run), smooth (median of that of the motion
## without singular positions), limit (the larger of 100 times that and 1e-12 a passage), calls
## (beside those of the smooth motion with the same step and grid), found (positions reported),
## loose (largest), failed (messages).

function r = passage_measure (s, rtol, pairs, seed)
  [steps, grids] = passage_draw (s.last, seed);
  r = struct ("energy", [], "calls", [], "found", [], "loose", 0, "failed", {{}});
  smooth = [];
  for p = pairs'
    options = {"rtol", rtol, "step", steps(p(1))};
    q = gsmbp_simulate (s.smooth, s.xs, grids{p(2)}, options{:});
    smooth(end+1) = change (s.smooth, q.x);
    try
      x = gsmbp_simulate (s.m, s.x0, grids{p(2)}, options{:});
    catch problem
      r.failed{end+1} = problem.message;
      continue;
    end
    r.energy(end+1) = change (s.m, x.x);
    r.calls(end+1) = x.stats.calls / q.stats.calls;
    r.found(end+1) = x.stats.singular_positions;
    r.loose = max (r.loose, x.stats.loose);
  end
  r.smooth = median (smooth);
  r.limit = max (100 * r.smooth, 1e-11);
end

function e = change (m, x)
  e = arrayfun (@(k) sum (m.ene (0, x(k,:)')(1:2)), 1:rows (x));
  e = max (abs (e / e(1) - 1));
end
