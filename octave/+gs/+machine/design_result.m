## r = gs.machine.design_result (d)
## What gsmbp_design gives back of the design D.

function r = design_result (d)
  r = struct ("met", isempty (d.unmet), "unmet", d.unmet, "decisions", d.decisions, "more", ...
              d.more, "notes", {d.notes}, "axes", d.axes, "cycles", d.cycles, ...
              "drives", d.drives, "attempts", d.attempts);
  for name = {"values", "model", "controller", "laws", "loops", "poses", "machine", ...
              "feedforward", "references", "margins", "corners", "derivatives", ...
              "yield", "holding"}
    r.(name{1}) = [];
    if (isfield (d, name{1}))
      r.(name{1}) = d.(name{1});
    endif
  endfor
  [r.best, r.runs] = deal (cell (1, 0));
  if (d.found)
    for j = 1:numel (d.axes)
      r.best{j} = d.drives(j).pairs(d.chosen(j));
    endfor
    r.runs = d.proof.runs;
  endif
endfunction
