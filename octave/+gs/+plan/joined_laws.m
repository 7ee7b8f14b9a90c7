## pp = gs.plan.joined_laws (parts)
## Piecewise polynomials of the same order one behind the other; those of no length are left
## out, but for the first where all are.

function pp = joined_laws (parts)
  long = cellfun (@(p) p.breaks(end) > p.breaks(1), parts);
  if (! any (long))
    pp = parts{1};
    return;
  endif
  parts = parts(long);
  breaks = parts{1}.breaks(1);
  coefs = [];
  n = prod (parts{1}.dim);
  for p = parts
    breaks = [breaks, p{1}.breaks(2:end)];
    coefs = cat (2, coefs, reshape (p{1}.coefs, n, p{1}.pieces, p{1}.order));
  endfor
  pp = mkpp (breaks, coefs, n);
endfunction
