## times = gsmbp__times (who, times)
## The times as a row; an error of WHO unless they are finite and increasing.

function times = gsmbp__times (who, times)
  if (! (isnumeric (times) && isreal (times) && isvector (times) && all (isfinite (times))))
    error ("%s: the times must be a vector of finite numbers", who);
  endif
  times = double (times(:)');
  if (any (diff (times) <= 0))
    k = find (diff (times) <= 0, 1);
    error (["%s: the times must be strictly increasing; number %d is %.15g, the next " "%.15g"], ...
           who, k, times(k), times(k+1));
  endif
endfunction
