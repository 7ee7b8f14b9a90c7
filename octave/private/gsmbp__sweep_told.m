## text = gsmbp__sweep_told (m, x0, times, rest, o, kept)
## What a sweep of the model M is, a line "what: value" for everything that its table follows from:
## two sweeps with the same lines have the same table.

function text = gsmbp__sweep_told (m, x0, times, rest, o, kept)
  lines = {["scene: " m.name], ["contents: " m.symbol(end-7:end)], ["precision: " m.precision], ...
           ["start: " gsmbp__sweep_text(x0(:)')], ["times: " gsmbp__sweep_text(times(:)')], ...
           ["plan: " o.plan], sprintf("runs: %d", o.runs), sprintf("seed: %d", o.seed), ...
           ["keep: " strjoin({kept.what}, ", ")]};
  if (! isempty (o.loop))
    lines{end+1} = ["loop: " gsmbp__sweep_text(o.loop)];
  endif
  if (any (strcmp (m.subroutines, "rhs_w")))
    lines{end+1} = sprintf ("lanes: %d", o.lanes);
  endif
  for name = fieldnames (o.vary)'
    lines{end+1} = ["vary " name{1} ": " gsmbp__sweep_text(o.vary.(name{1}))];
  endfor
  for k = 1:2:numel (rest)
    lines{end+1} = ["option " rest{k} ": " gsmbp__sweep_text(rest{k+1})];
  endfor
  for name = fieldnames (m.par)'
    lines{end+1} = ["parameter " name{1} ": " gsmbp__sweep_text(m.par.(name{1}))];
  endfor
  text = [strjoin(lines, "\n") "\n"];
endfunction
