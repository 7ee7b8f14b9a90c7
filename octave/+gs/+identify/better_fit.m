## list = gs.identify.better_fit (what, said, then, now)
## The sentence, in a cell, that WHAT (of measured data) fits better with one of the changes SAID;
## THEN, NOW: the residual over the signal with them and without.  {} where SAID is empty.

function list = better_fit (what, said, then, now)
  list = {};
  if (! isempty (said))
    list{1} = sprintf ("%s better with %s: the residual is then %.3g of the signal, now %.3g", ...
                       what, strjoin (said, ", or with "), then, now);
  endif
endfunction
