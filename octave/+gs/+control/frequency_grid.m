## w = gs.control.frequency_grid (p, delay, times)
## Frequencies [rad/s], rising, at which the plant P (continuous, or sampled: P.h) with dead time
## and a controller of these TIMES [s] shows what it does.

function w = frequency_grid (p, delay, times)
  s = [abs(eig (p.A)(:)); 1 ./ times(isfinite (times) & times > 0)(:)];
  if (delay > 0)
    s(end+1,1) = 1 / delay;
  endif
  if (p.h > 0)
    s(end+1,1) = 1 / p.h;
  endif
  s = s(s > 1e-9 * max ([s; realmin]));
  if (isempty (s))
    s = 1;
  endif
  [low, high] = deal (log10 (min (s)) - 3, log10 (max (s)) + 3);
  if (p.h > 0)
    high = log10 (pi / p.h * (1 - 1e-9));
  endif
  w = logspace (low, high, 150 * ceil (high - low));
  for r = imag (eig (p.A))(:)'   # resonances are narrow
    if (r > 0)
      near = r * (1 + [-1, 1]' * logspace (-6, -1, 40));
      w = [w, near(:)'];
    endif
  endfor
  if (p.h == 0 && delay > 0)
    w = [w, linspace(0.05, 40, 800) / delay];
  endif
  w = unique (w(w >= 10 ^ low & w <= 10 ^ high));
endfunction
