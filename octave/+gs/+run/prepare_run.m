## first = gs.run.prepare_run (who, p)
## The run P (gs.run.plan_run) up to its first step, refused where it cannot be: a struct with x
## (the state on the constraints, columns of derivatives behind it), rtol and atol.

function first = prepare_run (who, p)
  first = p.m.module ("prepare", p.m.cst, p.given);
  gs.run.refuse_run (who, p.m, first);
endfunction
