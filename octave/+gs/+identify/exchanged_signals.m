## list = gs.identify.exchanged_signals (m, data, regression)
## Sentences of the columns of measured DATA that fit much better with the other sign or swapped:
## efforts, the motion, or both together.

function list = exchanged_signals (m, data, regression)
  n = m.sizes.nu;
  now = misfit (regression, data, n);
  [best, said] = deal (0.5 * now, {});
  for kind = {"tau", "q", "all"}
    signs = zeros (1, ! strcmp (kind{1}, "all"));   # all of the other sign: often a mirrored motion
    for a = 1:n
      for b = [signs, a+1:n]
        off = misfit (regression, changed (data, kind{1}, a, b), n);
        if (off < 0.99 * best)
          [best, said] = deal (off, {});
        endif
        if (off < 1.01 * best && off < 0.5 * now)
          said{end+1} = words (m, kind{1}, a, b);
        endif
      endfor
    endfor
  endfor
  list = gs.identify.better_fit ("the data fit", said, best, now);
endfunction

## efforts, the motion or all, the column A with the other sign (B = 0) or swapped with B
function d = changed (d, kind, a, b)
  fields = struct ("tau", {{"tau"}}, "q", {{"q", "u", "ud"}}, "all", {{"q", "u", "ud", "tau"}});
  for name = fields.(kind)
    if (b == 0)
      d.(name{1})(:,a) *= -1;
    else
      d.(name{1})(:,[a b]) = d.(name{1})(:,[b a]);
    endif
  endfor
endfunction

function text = words (m, kind, a, b)
  head = {"effort.", ""}{1 + strcmp(kind, "q")};
  if (strcmp (kind, "all"))
    text = sprintf ("all columns of %s and %s swapped", m.coordinates{a}, m.coordinates{b});
  elseif (b == 0)
    text = sprintf ("%s%s of the other sign", head, m.coordinates{a});
  else
    text = sprintf ("%s%s and %s%s swapped", head, m.coordinates{a}, head, m.coordinates{b});
  endif
endfunction

## what is left of all efforts, each over its rms
function r = misfit (regression, d, n)
  w = regression (d);
  size_ = sqrt (mean (reshape (w.measured, n, []) .^ 2, 2)) + realmin;
  scale = size_(w.group);
  A = w.Y ./ scale;
  b = w.b ./ scale;
  r = norm (b - A * (A \ b)) / sqrt (rows (b));
endfunction
