## value = gs.text.run_limit (name)
## Return a limit of runs (share/engine/core/gsmbp/limits.h).

function value = run_limit (name)
  persistent limits = numbers (gs.text.table_rows ("GS_LIMITS"));
  value = limits.(name);
endfunction

function limits = numbers (rows)
  limits = cell2struct (num2cell (str2double (rows(:,2))), rows(:,1), 1);
endfunction
