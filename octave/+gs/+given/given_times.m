## times = gs.given.given_times (who, times)
## The times as a row; an error of WHO unless they are finite and increasing.

function times = given_times (who, times)
  if (! (isnumeric (times) && isreal (times) && isvector (times) && all (isfinite (times))))
    error ("%s: %s", who, gs.text.refusal_text ("times", found (times)));
  endif
  times = double (times(:)');
  if (any (diff (times) <= 0))
    k = find (diff (times) <= 0, 1);
    error ("%s: %s", who, gs.text.refusal_text ("rising_times", k, times(k), times(k+1)));
  endif
endfunction

function text = found (times)
  if (isempty (times))
    text = "none";
  elseif (! (isnumeric (times) && isreal (times)))
    text = gs.text.shown_value (times);
  elseif (! isvector (times))
    text = sprintf ("a %s matrix", sprintf ("%dx", size (times))(1:end-1));
  else
    k = find (! isfinite (times), 1);
    text = sprintf ("%g as number %d", times(k), k);
  endif
endfunction
