## tracked_figure (FILE, R, I): tracking errors and voltages of the machine that gsmbp_design made,
## in the I-th of its runs.

function tracked_figure (file, r, i)
  run = r.runs{i};
  error_ = struct ("y", 1e3 * run.error, "names", {{r.axes.coordinate}}, "label", ...
                   "error [mrad]");
  voltage = struct ("y", run.v(:,[r.axes.input]), "names", {strcat({r.axes.motor}, ".v")}, ...
                    "label", "voltage [V]");
  gsmbp_plot (file, run.t, error_, voltage, "title", ...
              "The machine with its controller: tracking errors and voltages");
endfunction
