## [w, t] = gs.identify.decimate_rows (who, w, t, n)
## The regression W at each N-th of its times, both its sides filtered alike without shift.  For
## columns well below the cutoff white noise counts w.gain times its deviation a row, which is
## w.estimated times that of what is left (the filter takes the noise above).

function [w, t] = decimate_rows (who, w, t, n)
  [w.gain, w.estimated] = deal (1);
  if (n <= 1)
    return;
  endif
  h = mean (diff (t));
  if (numel (t) < 2 || max (abs (diff (t) - h)) > 1e-4 * h)
    error ("%s: option decimate needs times at equal distances", who);
  endif
  cutoff = 0.4 / (n * h);
  keep = find (t >= t(1) + 1 / cutoff & t <= t(end) - 1 / cutoff)(1:n:end);
  if (isempty (keep))
    error ("%s: option decimate: %d times are too few for %d", who, numel (t), n);
  endif
  impulse = (1:40 * n + 1)' == 20 * n + 1;
  w.gain = 1 / sqrt (n);
  w.estimated = w.gain / norm (gs.identify.zero_phase (impulse, h, cutoff, 4));
  groups = max (w.group);
  [Y, b, measured, group] = deal (cell (groups, 1));
  for g = 1:groups
    own = w.group == g;
    all = gs.identify.zero_phase ([w.Y(own,:), w.b(own), w.measured(own)], h, cutoff, 4);
    all = all(keep,:);
    [Y{g}, b{g}, measured{g}] = deal (all(:,1:end-2), all(:,end-1), all(:,end));
    group{g} = repmat (g, numel (keep), 1);
  endfor
  [w.Y, w.b, w.measured] = deal (vertcat (Y{:}), vertcat (b{:}), vertcat (measured{:}));
  w.group = vertcat (group{:});
  t = t(keep);
endfunction
