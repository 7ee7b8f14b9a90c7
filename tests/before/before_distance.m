## e = before_distance (m, a, b)
## Return how far the runs A and B (before_run) of the model M are apart: the last states, at most,
## relative to their nominal magnitudes or larger values; the times of events [s]. NaN where one
## failed or the events are not the same.

function e = before_distance (m, a, b)
  e = [NaN, NaN];
  if (isempty (a.info) || isempty (b.info) || a.info != b.info || ! strcmp (a.events, b.events))
    return;
  end
  size = max ([m.nominal; ones(numel (a.x) - m.sizes.nx, 1)]', abs (a.x));
  e = [max(abs (a.x - b.x) ./ size), max([0, abs(a.times - b.times)])];
end
