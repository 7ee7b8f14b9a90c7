## p = gs.run.longest_delays (p, names, table)
## The plan P of one of many runs (gs.run.plan_many) with places for what sampled devices have
## on the way in any of them: periods and delays are those of the parameters NAMES, whose values
## are the rows of TABLE.

function p = longest_delays (p, names, table)
  if (isempty (p.m.controllers) || isempty (table))
    return;
  endif
  [~, which] = ismember (names, fieldnames (p.m.par)');
  [period, delay] = p.m.module ("periods", gs.model.parameter_values (p.m), which, table);
  places = @(k) p.m.module ("pending", period(:,k), delay(:,k), 0);
  p.arguments{11}.on_the_way = max (arrayfun (places, 1:columns (period)));
endfunction
