## w = gsmbp__weights (t)
## The weights of an integral over the times T, a column: of a cubic spline, if none is negative,
## else of straight lines.

function w = gsmbp__weights (t)
  n = numel (t);
  h = diff (t);
  w = ([h; 0] + [0; h]) / 2;
  if (n >= 4)
    pp = ppint (spline (t', eye (n)));
    smooth = ppval (pp, t(end)) - ppval (pp, t(1));
    if (all (smooth > 0))
      w = smooth(:);
    endif
  endif
endfunction
