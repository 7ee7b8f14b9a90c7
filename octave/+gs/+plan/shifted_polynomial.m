## c = gs.plan.shifted_polynomial (c, s)
## The polynomial C (as of polyval) about the point S.

function c = shifted_polynomial (c, s)
  if (abs (s) < 1e-14)
    return;
  endif
  for i = 1:numel (c) - 1
    for k = 2:numel (c) - i + 1
      c(k) += c(k-1) * s;
    endfor
  endfor
endfunction
