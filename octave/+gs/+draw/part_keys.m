## key = gs.draw.part_keys (parts)
## Entries of the legend for the kinds of PARTS that stand between bodies (gs.draw.part_symbol draws
## them), each kind once.

function key = part_keys (parts)
  key = {};
  kinds = unique (cellfun (@gs.draw.part_kind, {parts.kind}, "UniformOutput", false), "stable");
  styles = struct ("cylinder", "lines lw 8 lc rgb '#bbbbbb'", "spring", ...
                   "lines lw 1.5 lc rgb '#444444'", "damper", "lines lw 3 lc rgb '#444444'");
  for kind = setdiff (kinds, {"disc"}, "stable")
    key{end+1} = sprintf ("keyentry with %s title '%s'", styles.(kind{1}), kind{1});
  endfor
endfunction
