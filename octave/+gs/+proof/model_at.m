## [m, mc, own] = gs.proof.model_at (d, factors)
## The model, the machine with its controller and the tasks of the design D with parameters that are
## FACTORS (a struct by name) of their values; of those that a task gives, of the task's.

function [m, mc, own] = model_at (d, factors)
  [m, mc, own] = deal (d.model, d.machine, d.tasks);
  for name = fieldnames (factors)'
    f = factors.(name{1});
    value = d.model.par.(name{1}) * f;
    [m, mc] = deal (gsmbp_set (m, name{1}, value), gsmbp_set (mc, name{1}, value));
    for i = find (arrayfun (@(one) isfield (one.values, name{1}), own))
      own(i).values.(name{1}) *= f;
    endfor
  endfor
endfunction
