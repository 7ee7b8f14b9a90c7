## places = gsmbp__on_the_way (period, delay)
## How many places outputs of sampled devices need that are on their way (plan.h): PERIOD and DELAY
## of the devices [s], a column for each run; those of the run that needs most.

function places = gsmbp__on_the_way (period, delay)
  late = delay > 0 & period > 0;
  places = max (sum (late .* (floor (delay ./ (period + ! late) + 1e-9) + 2), 1));
endfunction
