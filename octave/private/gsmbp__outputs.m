## y = gsmbp__outputs (m, t, x, v)
## The outputs of the scene along a result, a row for each time; NaN where they are not emitted or
## cannot be calculated.

function y = gsmbp__outputs (m, t, x, v)
  y = NaN (numel (t), m.sizes.ny);
  if (m.sizes.ny == 0 || ! any (strcmp (m.subroutines, "out")))
    return;
  endif
  for k = find (all (isfinite ([x, v]), 2))'
    [row, info] = m.out (t(k), x(k,:), v(k,:));
    if (info == 0 || info == 2)
      y(k,:) = row;
    endif
  endfor
endfunction
