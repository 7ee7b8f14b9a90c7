## p = panel (Y, NAMES, LABEL, HEADING): curves Y (columns) of one axis of gsmbp_plot, their NAMES,
## the LABEL of the axis with its unit; HEADING (may be left out): the condition, above the panel.

function p = panel (y, names, label, heading = "")
  p = struct ("y", y, "names", {names}, "label", label, "heading", heading);
endfunction
