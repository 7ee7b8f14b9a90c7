## [R, parts] = gs.optimize.end_slopes (m, R, n, names)
## A run R of the model M as a load case has it: with N rows, those behind the event that ends it
## as the last one, the weights w of an integral and extra.end_time.  PARTS: its derivatives by
## NAMES, a struct array of x, v, y, t, w and extra; the end moves with its event.  Scenes without
## such events have no w here: the weights are always the same.

function [R, parts] = end_slopes (m, R, n, names)
  parts = struct ("x", {}, "v", {}, "y", {}, "t", {}, "w", {}, "extra", {});
  k = numel (R.t);
  ended = strncmp (R.stats.stopped, "event ", 6);
  ends = gs.events.may_end (m);
  R.extra = struct ("end_time", R.t(end));
  [w_end, rates] = deal (zeros (k, 1), []);
  if (ends)
    R.w = [m.module("weights", R.t(:)); zeros(n - k, 1)];
  endif
  if (ended && ! isempty (names))
    [~, w_end] = m.module ("weights", R.t(:));
    rates = end_rates (m, R);
  endif
  for name = names
    [dt, t] = deal (0, zeros (k, 1));
    [x, y] = deal (R.dx.(name{1}), R.dy.(name{1}));
    if (ended)
      dt = R.events.dt.(name{1})(last_stop (m, R));
      t(end) = dt;
      x(end,:) += dt * rates.x';
      y(end,:) += dt * rates.y';
    endif
    parts(end+1) = struct ("x", x, "v", R.dv.(name{1}), "y", y, "t", t, "w", dt * w_end, ...
                           "extra", struct ("end_time", dt));
  endfor
  R = filled (R, {"t", "x", "v", "y", "points", "state_margins"}, n);
  for k = 1:numel (parts)
    parts(k) = filled (parts(k), {"t", "x", "v", "y"}, n);
    parts(k).w(end+1:n,1) = 0;
  endfor
endfunction

## with the last rows once more, up to N
function R = filled (R, fields, n)
  for name = fields
    if (isfield (R, name{1}))
      value = R.(name{1});
      R.(name{1}) = value(min (1:n, rows (value)),:);
    endif
  endfor
endfunction

## the number of the event that ends the run
function k = last_stop (m, R)
  k = find (R.events.t == R.t(end) & [m.events(R.events.number).ends]', 1);
endfunction

## rates of states and outputs at the end, under inputs that stay as they are
function rates = end_rates (m, R)
  [t, x, v] = deal (R.t(end), R.x(end,:)', R.v(end,:)');
  rates.x = m.rhs (t, x, v);
  rates.y = zeros (m.sizes.ny, 1);
  if (m.sizes.ny > 0)
    [~, ~, C] = m.jac (t, x, v);
    h = 1e-3 * max (1, abs (t));
    y = @(s) m.out (t + s * h, x, v);
    rates.y = C * rates.x + (8 * (y (1) - y (-1)) - (y (2) - y (-2))) / (12 * h);
  endif
endfunction
