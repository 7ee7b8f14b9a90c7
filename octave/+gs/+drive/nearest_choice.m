## text = gs.drive.nearest_choice (found)
## Which of FOUND, none of them feasible, breaks its limits least.

function text = nearest_choice (found)
  most = cellfun (@(u) max (cell2mat (struct2cell (u))), {found.utilization});
  [least, k] = min (most);
  text = sprintf ("%s is nearest (%s; %.4g times what it may)", found(k).name, ...
                  strjoin (found(k).violated, ", "), least);
endfunction
