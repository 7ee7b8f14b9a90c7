## p = gsmbp__machine_proof (d, factors)
## The machine of the design D with parameters that are FACTORS (a struct by name) of their values:
## runs of all tasks on the non-linear model with its controller, load cycles, the loads at rest,
## and what is found beside what is allowed (gsmbp__machine_measures).

function p = gsmbp__machine_proof (d, factors)
  [m, mc, own] = gsmbp__machine_at (d, factors);
  for i = 1:numel (own)
    p.runs{i} = gsmbp__machine_run (d, m, mc, i, own(i));
  endfor
  p.cycles = gsmbp__machine_cycles (m, d.axes, own);
  p.rest = gsmbp__machine_rest (m, d.axes, own);
  p.measures = gsmbp__machine_measures (d, m, p);
endfunction
