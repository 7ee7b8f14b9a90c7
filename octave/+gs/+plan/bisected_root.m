## x = gs.plan.bisected_root (f, a, b)
## Where f, not below 0 at A and below 0 at B > A, changes its sign: bisection down to
## neighbouring numbers, by the mean of the exponents where they are far apart.

function x = bisected_root (f, a, b)
  for k = 1:300
    x = a + (b - a) / 2;
    if (a >= 0 && b > 16 * a)
      x = max (sqrt (max (a, 1e-16 * b) * b), a);
    endif
    if (x <= a || x >= b)
      break;
    elseif (f (x) >= 0)
      a = x;
    else
      b = x;
    endif
  endfor
  x = a;
endfunction
