## p = gs.proof.prove_at (d, factors)
## The machine of the design D with parameters that are FACTORS (a struct by name) of their values:
## runs of all tasks on the non-linear model with its controller, load cycles, the loads at rest,
## and what is found beside what is allowed (gs.proof.list_measures).

function p = prove_at (d, factors)
  [m, mc, own] = gs.proof.model_at (d, factors);
  for i = 1:numel (own)
    p.runs{i} = gs.proof.run_motion (d, m, mc, i, own(i));
  endfor
  p.cycles = gs.drive.load_cycles (m, d.axes, own);
  p.rest = gs.drive.rest_loads (m, d.axes, own);
  p.measures = gs.proof.list_measures (d, m, p);
endfunction
