## [K, Ti, Td] = gs.control.pid_tuned (who, p, o, kind, goal)
## Gain and times of a controller of the KIND for the plant P that meets the GOAL: the largest gain
## of a stable loop for given times; without them the times as gsmbp_pid says.

function [K, Ti, Td] = pid_tuned (who, p, o, kind, goal)
  [p.plant_a, p.plant_b, p.plant_c] = ssdata (p.plant);
  p.response = gs.control.frequency_response (p.plant_a, p.plant_b, p.plant_c);
  q.p = p;
  q.o = o;
  q.w = gs.control.frequency_grid (p, o.delay, [o.Ti, o.Td]);
  q.P = response (p, q.w, o.delay);
  has = @(letter) any (kind == letter);
  Ti = merge (has ("i"), o.Ti, Inf);
  Td = merge (has ("d"), o.Td, 0);
  if (columns (goal) == 2)
    [K, Ti] = both_margins (q, goal);
  elseif (isempty (Ti))
    tied = @(T) merge (isempty (Td), T / 4, Td);
    Ti = best (q, @(T) gain (q, T, tied (T), goal, true) / T);
    Td = tied (Ti);
    K = gain (q, Ti, Td, goal);
  elseif (isempty (Td))
    if (has ("i"))
      Td = Ti / 4;
    else
      Td = best (q, @(T) gain (q, Inf, T, goal, true));
    endif
    K = gain (q, Ti, Td, goal);
  else
    K = gain (q, Ti, Td, goal);
  endif
  if (isempty (K) || ! isfinite (K) || K == 0)
    said = sprintf (", %s = %g", goal{:});
    error (["%s: no gain of a \"%s\" meets %s with a stable loop; expected a lower goal, or " ...
            "other times Ti, Td"], who, kind, said(3:end));
  endif
endfunction

## the plant by frequencies
function P = response (p, w, delay)
  if (p.h > 0)
    P = p.response (exp (1i * w * p.h));
  else
    P = p.response (1i * w) .* exp (-1i * w * delay);
  endif
endfunction

## the controller of gain 1
function C = shape (q, w, Ti, Td)
  h = q.p.h;
  Tf = Td / q.o.N;
  C = ones (size (w));
  if (h > 0)
    z = exp (1i * w * h);
    C += h / Ti ./ (z - 1);
    if (Td > 0)
      C += Td * (z - 1) ./ ((Tf + h) * z - Tf);
    endif
  else
    C += 1 ./ (1i * w * Ti) + Td * 1i * w ./ (1 + Tf * 1i * w);
  endif
endfunction

## the largest gain (by its modulus) that meets the goal with a stable loop; 0: none.  ROUGH: as the
## frequencies of q.w show it
function K = gain (q, Ti, Td, goal, rough = false)
  L = q.P .* shape (q, q.w, Ti, Td);
  f = @(w) response (q.p, w, q.o.delay) .* shape (q, w, Ti, Td);
  switch (goal{1})
    case "pm"
      tries = on_ray (q, L, f, goal{2} * pi / 180, 1, rough);
    case "gm"
      tries = on_ray (q, L, f, 0, goal{2}, rough);
    case "ms"
      tries = by_sensitivity (q, L, f, goal{2}, rough);
  endswitch
  K = 0;
  [~, order] = sort (abs (tries), "descend");
  for k = tries(order)(:)'
    if (stable (q, L, f, k, Ti, Td) && (rough || met (q, L, f, k, goal)))
      K = k;
      return;
    endif
  endfor
endfunction

## gains for which the loop crosses the unit circle (over FACTOR) at the angle PHI past -1
function K = on_ray (q, L, f, phi, factor, rough)
  K = [];
  for side = [1, -1]
    g = @(L) side * L * exp (-1i * phi);   # crosses the negative axis
    v = imag (g (L));
    at = find (v(1:end-1) .* v(2:end) <= 0 & real (g (L(1:end-1))) < 0)(:)';
    [~, order] = sort (abs (L(at)), "descend");
    for k = at(order(1:min (8, end)))   # smaller ones ask for gains beyond these
      if (rough)
        part = v(k) / (v(k) - v(k+1));
        K(end+1) = side / (factor * abs (L(k) + part * (L(k+1) - L(k))));
        continue;
      endif
      w = fzero (@(w) imag (g (f (w))), q.w([k, k+1]), optimset ("TolX", eps));
      K(end+1) = side / (factor * abs (f (w)));
    endfor
  endfor
endfunction

## gains of which the largest sensitivity is MS
function K = by_sensitivity (q, L, f, ms, rough)
  K = [];
  for side = [1, -1]
    all_ = side * logspace (-4, 4, 121) / median (abs (L));
    top = max (1 ./ abs (1 + L(:) * all_), [], 1);
    for i = find ((top(1:end-1) - ms) .* (top(2:end) - ms) <= 0)(:)'
      if (rough)
        part = log (ms / top(i)) / log (top(i+1) / top(i));
        K(end+1) = all_(i) * (all_(i+1) / all_(i)) ^ part;
        continue;
      endif
      g = @(x) log (sensitivity (q, L, f, side * exp (x)) / ms);
      ends = log (abs (all_([i, i+1])));
      if (g (ends(1)) * g (ends(2)) <= 0)
        K(end+1) = side * exp (fzero (g, ends, optimset ("TolX", eps)));
      endif
    endfor
  endfor
endfunction

function top = sensitivity (q, L, f, K)
  [~, k] = max (1 ./ abs (1 + K * L));
  ends = q.w([max(k - 1, 1), min(k + 1, numel (q.w))]);
  g = @(w) abs (1 + K * f (w));
  w = fminbnd (g, ends(1), ends(2), optimset ("TolX", 1e-11 * ends(2)));
  top = 1 / min (g (w), abs (1 + K * L(k)));
endfunction

## is the loop's own margin that of the goal, not a smaller one elsewhere?
function yes = met (q, L, f, K, goal)
  if (strcmp (goal{1}, "ms"))
    yes = true;
    return;
  endif
  r = gs.control.loop_margins (@(w) K * f (w), q.w, K * L, false);
  if (strcmp (goal{1}, "pm"))
    yes = abs (r.phase - goal{2} * pi / 180) < 1e-6;
  else
    yes = abs (r.gain / goal{2} - 1) < 1e-6;
  endif
endfunction

## Nyquist: the angle of 1 + L grows by pi for each unstable pole of the open loop, by half of it
## for each integrator
function yes = stable (q, L, f, K, Ti, Td)
  s = eig (q.p.A);
  small = 1e-9 * max ([abs(s); 1e-300]);
  if (q.p.h > 0)
    yes = max (abs (closed_samples (q, K, Ti, Td))) < 1;
    return;
  endif
  unstable = sum (real (s) > small);
  still = sum (abs (s) <= small) + isfinite (Ti);
  ## beyond the last frequency where |L| is not small it does not turn any more
  n = min ([find(abs (K * L) > 0.9, 1, "last") + 1, numel(L)]);
  w = q.w(1:n);
  v = 1 + K * L(1:n);
  for round_ = 1:12   # more frequencies where it turns fast
    turn = abs (angle (v(2:end) ./ v(1:end-1)));
    k = find (turn > 0.3);
    if (isempty (k))
      break;
    endif
    between = sqrt (w(k) .* w(k+1));
    [w, order] = sort ([w, between]);
    v = [v, 1 + K * f(between)](order);
  endfor
  turned = sum (angle (v(2:end) ./ v(1:end-1))) - angle (v(end));
  expected = pi * unstable + pi / 2 * still;
  yes = abs (turned - expected) < 1;
endfunction

## poles of plant and controller at the samples
function z = closed_samples (q, K, Ti, Td)
  [F, H, S] = deal (q.p.plant_a, q.p.plant_b, q.p.plant_c);
  h = q.p.h;
  Tf = Td / q.o.N;
  a = Tf / (Tf + h);
  b = K * Td / (Tf + h);
  A = blkdiag (1, a);
  B = -[K / Ti * h; b * (a - 1)];
  D = -K - b;
  z = eig ([F + H * D * S, H * [1, 1]; B * S, A]);
  if (! isfinite (Ti))
    [~, k] = min (abs (z - 1));   # the integral that is not there
    z(k) = [];
  endif
endfunction

## the time of the largest value, to three digits: it is flat there
function T = best (q, value)
  times = logspace (log10 (1 / q.w(end)) + 1, log10 (1 / q.w(1)) - 1, 40);
  found = arrayfun (@(T) abs (value (T)), times);
  [top, k] = max (found);
  if (top == 0)
    T = times(1);
    return;
  endif
  ends = log (times([max(k - 1, 1), min(k + 1, numel (times))]));
  T = exp (fminbnd (@(x) -abs (value (exp (x))), ends(1), ends(2), optimset ("TolX", 1e-3)));
  unit = 10 ^ (floor (log10 (T)) - 2);
  T = unit * round (T / unit);
endfunction

## PI: of the gains that keep the phase margin the one that has the gain margin
function [K, Ti] = both_margins (q, goal)
  K = Ti = [];
  k = strcmp (goal(1,:), "pm");
  phase = goal(:,k);
  wanted = goal{2,! k};
  times = logspace (log10 (1 / q.w(end)) + 1, log10 (1 / q.w(1)) - 1, 40);
  away = arrayfun (@(T) missed (q, T, phase, wanted, true), times);
  for i = find (away(1:end-1) .* away(2:end) <= 0 & isfinite (away(1:end-1) + away(2:end)))
    g = @(x) missed (q, exp (x), phase, wanted, false);
    ends = log (times([i, i+1]));
    if (! (g (ends(1)) * g (ends(2)) <= 0))
      continue;
    endif
    x = fzero (g, ends, optimset ("TolX", eps));
    k = gain (q, exp (x), 0, phase);
    if (isempty (K) || abs (k / exp (x)) > abs (K / Ti))
      [K, Ti] = deal (k, exp (x));
    endif
  endfor
endfunction

function d = missed (q, Ti, phase, wanted, rough)
  d = NaN;
  K = gain (q, Ti, 0, phase, rough);
  if (K != 0)
    r = gs.control.loop_margins (@(w) K * response (q.p, w, q.o.delay) .* shape (q, w, Ti, 0), ...
                                 q.w, K * q.P .* shape (q, q.w, Ti, 0), false);
    d = log (r.gain / wanted);
  endif
endfunction
