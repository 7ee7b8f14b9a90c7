## text = gsmbp__nearest (found)
## Which of FOUND, none of them feasible, breaks its limits least.

function text = gsmbp__nearest (found)
  most = cellfun (@(u) max (cell2mat (struct2cell (u))), {found.utilization});
  [least, k] = min (most);
  text = sprintf ("%s is nearest (%s; %.4g times what it may)", found(k).name, ...
                  strjoin (found(k).violated, ", "), least);
endfunction
