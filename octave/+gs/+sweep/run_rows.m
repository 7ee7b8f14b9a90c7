## r = gs.sweep.run_rows (s, i)
## The runs I of the sweep S (gs.sweep.run_blocks) as gs.run.many_runs has them.

function r = run_rows (s, i)
  table = s.table(i,:);
  [~, which] = ismember (s.names, fieldnames (s.m.par)');
  broken = gs.model.broken_rules (s.m, cell2struct (num2cell (table, 1), s.names, 2));
  r = struct ("n", numel (i), "which", which(:), "table", table, "starts", [], "inputs", [], ...
              "broken", {broken}, "threads", s.threads, "lanes", s.lanes);
endfunction
