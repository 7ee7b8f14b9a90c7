## p = gsmbp__machine_proof (d, factors)
## The machine of the design D with parameters that are FACTORS (a struct by name) of their values:
## runs of all tasks on the non-linear model with its controller, load cycles, and what is found
## beside what is allowed: measures, a row of structs: axis, name, unit, found, limit, used (found
## beside the limit).

function p = gsmbp__machine_proof (d, factors)
  names = fieldnames (factors)';
  [m, mc, own] = deal (d.model, d.machine, d.tasks);
  for k = 1:numel (names)
    f = factors.(names{k});
    value = d.model.par.(names{k}) * f;
    [m, mc] = deal (gsmbp_set (m, names{k}, value), gsmbp_set (mc, names{k}, value));
    for i = find (arrayfun (@(one) isfield (one.values, names{k}), own))
      own(i).values.(names{k}) *= f;
    endfor
  endfor
  for i = 1:numel (own)
    p.runs{i} = gsmbp__machine_run (d, m, mc, i, own(i));
  endfor
  p.cycles = gsmbp__machine_cycles (m, d.axes, own);
  p.measures = gsmbp__machine_measures (d, m, p);
endfunction
