## text = gs.sweep.describe_sweep (m, x0, times, rest, o, kept)
## What a sweep of the model M is, a line "what: value" for everything that its table follows from:
## two sweeps with the same lines have the same table.

function text = describe_sweep (m, x0, times, rest, o, kept)
  lines = {["scene: " m.name], ["contents: " m.symbol(end-7:end)], ["precision: " m.precision], ...
           ["start: " gs.sweep.value_text(x0(:)')], ["times: " gs.sweep.value_text(times(:)')], ...
           ["plan: " o.plan], sprintf("runs: %d", o.runs), sprintf("seed: %d", o.seed), ...
           ["keep: " strjoin({kept.what}, ", ")]};
  if (! isempty (o.loop))
    lines{end+1} = ["loop: " gs.sweep.value_text(o.loop)];
  endif
  if (any (strcmp (m.subroutines, "rhs_w")))
    lines{end+1} = sprintf ("lanes: %d", o.lanes);
  endif
  for name = fieldnames (o.vary)'
    lines{end+1} = ["vary " name{1} ": " gs.sweep.value_text(o.vary.(name{1}))];
  endfor
  for k = 1:2:numel (rest)
    lines{end+1} = ["option " rest{k} ": " gs.sweep.value_text(rest{k+1})];
  endfor
  for name = fieldnames (m.par)'
    lines{end+1} = ["parameter " name{1} ": " gs.sweep.value_text(m.par.(name{1}))];
  endfor
  text = [strjoin(lines, "\n") "\n"];
endfunction
