## r = gsmbp__sweep_rows (s, i)
## The runs I of the sweep S (gsmbp__sweep_runs) as gsmbp__many_runs has them.

function r = gsmbp__sweep_rows (s, i)
  table = s.table(i,:);
  [~, which] = ismember (s.names, fieldnames (s.m.par)');
  broken = gsmbp__broken_rules (s.m, cell2struct (num2cell (table, 1), s.names, 2));
  r = struct ("n", numel (i), "which", which(:), "table", table, "starts", [], "inputs", [], ...
              "broken", {broken}, "threads", s.threads, "lanes", s.lanes);
endfunction
