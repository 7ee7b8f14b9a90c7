## [poles, worst] = gs.control.closed_poles (c)
## The poles of the plant of the controller C together with it (of z with a period; the delay of a
## continuous controller does not belong to it), and how far the WORST is beyond the limit of
## stability: below 0 all are within.

function [poles, worst] = closed_poles (c)
  poles = eig (gs.control.closed_loop (c));
  worst = max ([real(poles); -Inf]);
  if (c.period > 0)
    worst = max ([abs(poles) - 1; -Inf]);
  endif
endfunction
