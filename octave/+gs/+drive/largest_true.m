## x = gs.drive.largest_true (f, low, high)
## The largest X between LOW and HIGH, to a thousandth of itself, up to which F is true, by
## bisection; 0 where F (LOW) is false.

function x = largest_true (f, low, high)
  x = 0;
  if (! f (low))
    return;
  elseif (f (high))
    x = high;
    return;
  endif
  while (high > low * 1.001)
    middle = sqrt (low * high);
    if (f (middle))
      low = middle;
    else
      high = middle;
    endif
  endwhile
  x = low;
endfunction
