## p = panel (Y, NAMES, LABEL): curves Y (columns) of one axis of gsmbp_plot, their NAMES, the LABEL
## of the axis with its unit.

function p = panel (y, names, label)
  p = struct ("y", y, "names", {names}, "label", label);
endfunction
