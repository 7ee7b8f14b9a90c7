## text = gs.machine.share_text (pair)
## What a pair of gsmbp_drive uses most of its limits, the three largest.

function text = share_text (pair)
  names = fieldnames (pair.utilization);
  [use, order] = sort (cell2mat (struct2cell (pair.utilization)), "descend");
  said = @(k) sprintf ("%s %.0f %%", names{order(k)}, 100 * use(k));
  parts = arrayfun (said, 1:min (3, numel (use)), "UniformOutput", false);
  text = ["used: " strjoin(parts, ", ")];
endfunction
