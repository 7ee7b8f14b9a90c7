## list = gs.identify.list_doubts (m, data, e, regression)
## Doubts in the DATA of the estimates E of gsmbp_identify, a cell array of sentences: positions
## outside the limits of their joints, speeds that are not the rates of the positions, residuals
## that are large against the signal or SIGMA, estimates that no body has, residuals that follow the
## noise of the accelerations, columns that fit better swapped, with the other sign, shifted in time
## or times a factor.  REGRESSION makes of data what gs.identify.regression_rows gives.

function list = list_doubts (m, data, e, regression)
  list = [large(m, e), impossible(m, e)];
  if (! isempty (list) && isempty (e.options.motors))
    list = [list, gs.identify.exchanged_signals(m, data, regression)];
  endif
  rates = gs.identify.wrong_rates (m, data);
  if (isempty (rates) && isempty (e.options.motors))
    w = regression (data);
    of_efforts = gs.identify.rescaled_efforts (m, w);
    if (isempty (of_efforts))
      of_efforts = gs.identify.late_efforts (m, data, w);
    endif
    list = [list, of_efforts];
  endif
  list = [outside(m, data), rates, list, noisy(m, data, e)];
endfunction

function list = outside (m, data)
  list = {};
  limits = gs.model.scene_limits (m, m.coordinates);
  for j = 1:m.sizes.nu
    [low, high] = deal (limits(j,1), limits(j,2));
    room = 0.01 * (high - low);
    far = max ([low - data.q(:,j), data.q(:,j) - high], [], 2);
    [most, k] = max (far);
    if (most > room)
      list{end+1} = sprintf (["%s = %.4g %s is outside the limits of its joint, %.4g to %.4g; " ...
                              "%d of %d rows are: check the unit of this column"], ...
                             m.coordinates{j}, data.q(k,j), m.units.coordinates{j}, low, high, ...
                             sum (far > room), rows (far));
    endif
  endfor
endfunction

## residuals above rounding; of an effort that is zero itself, above a small part of the others
function list = large (m, e)
  list = {};
  signal = e.rms ./ e.relative;
  least = [1e-12, 1e-3](1 + (signal < 1e-9 * max (signal))) * max (signal);
  for g = 1:m.sizes.nu
    name = ["effort." m.coordinates{g}];
    allowed = Inf;
    if (! isempty (e.options.sigma))
      allowed = e.noise(g);
    endif
    if (e.rms(g) > 3 * allowed)
      list{end+1} = sprintf (["%s: the residual has an rms of %.3g, which is %.3g times its " ...
                              "sigma"], name, e.rms(g), e.rms(g) / allowed);
    elseif (e.relative(g) > 0.3 && e.rms(g) > least(g)
            && ! (e.rms(g) < 1.5 * allowed && isfinite (allowed)))
      list{end+1} = sprintf (["%s: the residual has an rms of %.3g, which is %.2g of the " ...
                              "signal"], name, e.rms(g), e.relative(g));
    endif
  endfor
endfunction

## estimates below zero, by more than rounding, that are sums of masses, moments about axes,
## frictions; others that no body has, by what chi2 gains where a body is found
function list = impossible (m, e)
  list = {};
  s = gs.identify.standard_parameters (m);
  for k = gs.identify.negative_values (m, s, e)
    part = -e.p(k) * norm (e.R(:,k)) / (norm (e.z) + realmin);   # of the efforts
    if (e.p(k) < -3 * e.sigma(k) && part > 1e-9)
      list{end+1} = sprintf ("%s = %.4g +- %.2g is negative, which no body is", e.names{k}, ...
                             e.p(k), e.sigma(k));
    endif
  endfor
  if (! isempty (list) || sum (strcmp (e.kind, "base")) < numel (m.json.base_parameters) ...
      || gs.identify.bodies_near (s, e))
    return;
  endif
  state = warning ("off", "gsmbp:consistent", "local");
  try
    gain = gsmbp_consistent (m, e).gain;
  catch
    return;   # the search did not converge: nothing is said
  end_try_catch
  if (gain > 25 && gain > 1e-9 * sumsq (e.z))
    list{end+1} = sprintf (["no body has these masses and inertias: the nearest estimates that " ...
                            "bodies have (gsmbp_consistent) raise chi2 by %.3g"], gain);
  endif
endfunction

## the noise of positions: what the accelerations have above the motion itself, where this is not
## more than noise can make of it (else the filter took it from the motion)
function list = noisy (m, data, e)
  list = {};
  [extra, raw, most_noise] = above_motion (data, e);
  if (isempty (extra))
    return;
  endif
  for g = 1:m.sizes.nu
    r = e.residual(:,g);
    size_ = @(x) sqrt (mean (x .^ 2));
    c = (extra' * r) ./ (numel (r) * size_ (extra)' * size_ (r) + realmin);
    c(size_ (extra) < 1e-6 * size_ (data.ud) | size_ (extra) > most_noise) = 0;
    [most, j] = max (abs (c));
    if (most * sqrt (numel (r)) > 5 && most > 0.1 && e.relative(g) > 1e-6)
      list{end+1} = sprintf (["effort.%s: the residual correlates by %.2f with the noise of " ...
                              "the acceleration of %s (rms %.3g): noise of its positions " ...
                              "biases the estimates; a filter at %.2g Hz (gsmbp_measured, " ...
                              "option cutoff) or option method \"total\" takes it away"], ...
                             m.coordinates{g}, c(j), ...
                             m.coordinates{j}, size_ (extra(:,j)), ...
                             gs.identify.best_cutoff (raw.t, raw.q, 4));
    endif
  endfor
endfunction

## at the times of the residuals; the positions as measured; MOST_NOISE: an upper bound of the rms
## that their noise has in the accelerations below the cutoff (without one: below half the sampling
## frequency)
function [extra, raw, most_noise] = above_motion (data, e)
  [extra, raw, most_noise] = deal ([], data, 0);
  if (strcmp (e.options.method, "total") || columns (e.residual) != columns (data.q) ...
      || rows (e.residual) < 100)
    return;
  elseif (isfield (data, "raw"))
    raw = data.raw;
  endif
  s = gs.identify.smooth_spline (raw.t, raw.q);
  if (isempty (s))
    return;
  endif
  cutoff = 0.5 / median (diff (raw.t));
  if (isfield (data, "cutoff") && ! isempty (data.cutoff))
    cutoff = data.cutoff;
  endif
  most_noise = 3 * (2 * pi * cutoff) ^ 2 * s.noise;
  extra = interp1 (data.t, data.ud, e.t) - interp1 (raw.t, s.B{3} * s.c, e.t);
endfunction
