## loads = gs.drive.axis_loads (m, axes_, plan, t)
## The load cycle of each axis of the model M of gs.machine.ideal_machine along the PLAN at the
## times T, a row of cells.

function loads = axis_loads (m, axes_, plan, t)
  warning ("off", "gsmbp:drive", "local");
  r = gsmbp_inverse (m, plan, t, "quasistatic", true);
  loads = arrayfun (@(a) gsmbp_cycle (m, r, a.coordinate), axes_, "UniformOutput", false);
endfunction
