## cutoff = gs.identify.best_cutoff (t, q, order)
## Return the cutoff [Hz] of the filter gs.identify.zero_phase of an ORDER with which accelerations
## by differences of the positions Q at the times T have the least error: what the filter takes from
## the smooth motion (gs.identify.smooth_spline), less what of this is noise, and the noise that it
## leaves; each over the accelerations of its coordinate.  [] where the times are too few.

function cutoff = best_cutoff (t, q, order)
  s = gs.identify.smooth_spline (t, q, 1);
  cutoff = [];
  if (isempty (s))
    return;
  endif
  h = mean (diff (t));
  whole = max (sqrt (mean ((s.B{3} * s.c) .^ 2)), realmin);
  impulse = zeros (2 * min (2000, floor (numel (t) / 2)) + 1, 1);
  impulse((end+1)/2) = 1;
  accelerations = @(x, f) nthargout (2, @gs.identify.time_differences, ...
                                      gs.identify.zero_phase (x, h, f, order), h);
  [least, cutoff] = deal (Inf, 0.4 / h);
  for f = logspace (log10 (4 / (t(end) - t(1))), log10 (0.4 / h), 25)
    bend = accelerations (full (s.B{1}), f) - s.B{3};
    bend = bend(! isnan (bend(:,1)) & t >= t(1) + 1 / f & t <= t(end) - 1 / f,:);
    if (isempty (bend))
      continue;
    endif
    bent = mean ((bend * s.c) .^ 2, 1) - s.noise .^ 2 * sumsq ((bend / s.R)(:)) / rows (bend);
    gain = accelerations (impulse, f);
    left = sumsq (gain(! isnan (gain))) * s.noise .^ 2;
    off = sum ((max (bent, 0) + left) ./ whole .^ 2);
    if (off < least)
      [least, cutoff] = deal (off, f);
    endif
  endfor
endfunction
