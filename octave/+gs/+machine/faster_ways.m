## list = gs.machine.faster_ways (d)
## How much faster the drives of the design D bear the same motion, what stops them, and what 10 %
## more of it, or of the motor, would give: items of gs.machine.more_options. By the load cycles
## alone.

function list = faster_ways (d)
  at = cycles_by_pace (d);
  [far, broken] = reach (d, at, d.motors, d.gears);
  list = struct ("what", "speed", "axis", "", "value", far, "said", ...
                 sprintf (["the drives bear the same motion %.4g times as fast, by its load " ...
                           "cycles; what stops it is %s"], far, said (d, broken)));
  if (isempty (broken))
    return;
  endif
  j = broken(1).axis;
  name = d.axes(j).coordinate;
  [motors, gears] = deal (d.motors, d.gears);
  [motors(j), gears(j), what] = more_of (motors(j), gears(j), broken(1).names{1});
  [farther, then] = reach (d, at, motors, gears);
  list(end+1) = struct ("what", "limit", "axis", name, "value", farther, "said", ...
                        sprintf (["%s: with 10 %% more of its %s it is %.4g times as fast; " ...
                                  "then it is %s"], name, what, farther, said (d, then)));
  cycles = at (far * 1.1);
  drives = gs.drive.choose_drives (setfield (d.asked, "reserve", 0), cycles(j));
  old = d.drives(j).pairs(d.chosen(j));
  goal = d.asked.goal;
  if (isempty (drives.order))
    list(end+1) = struct ("what", "drive", "axis", name, "value", NaN, "said", ...
                          sprintf (["%s: no pair of the catalogue bears the motion %.4g times " ...
                                    "as fast"], name, far * 1.1));
    return;
  endif
  new = drives.pairs(drives.order(1));
  list(end+1) = struct ("what", "drive", "axis", name, "value", new.(goal), "said", ...
                        sprintf (["%s: %.4g times as fast the best pair for it is %s: %s %.4g " ...
                                  "instead of %.4g of %s at the speed that is asked"], name, ...
                                 far * 1.1, new.name, ...
                                 strrep (goal, "_", " "), new.(goal), old.(goal), old.name));
endfunction

## the load cycles f times as fast: speeds with f, accelerations with f^2, torques as a parabola in
## f through three paces (of what is rigid and has no dry friction exactly)
function at = cycles_by_pace (d)
  f = [0.5, 1, 2];
  for k = 1:3
    c(k,:) = gs.drive.load_cycles (d.model, d.axes, gs.drive.paced_motions (d.tasks, f(k)), 101);
  endfor
  for j = 1:columns (c)
    by_power{j} = [c(:,j).torque] / (f .^ [0; 1; 2]);
  endfor
  at = @(x) arrayfun (@(j) paced (c(2,j), by_power{j}, x), 1:columns (c));
endfunction

function c = paced (c, T, f)
  c.t /= f;
  c.omega *= f;
  c.alpha *= f ^ 2;
  c.torque = T * [1; f; f ^ 2];
endfunction

## the largest factor that all drives bear, up to 10, and what is broken beyond it
function [far, broken] = reach (d, at, motors, gears)
  ok = @(f) isempty (broken_at (d, at (f), motors, gears));
  far = gs.drive.largest_true (ok, 0.05, 10);
  broken = broken_at (d, at (max (far, 0.05) * 1.002), motors, gears);
endfunction

function list = broken_at (d, cycles, motors, gears)
  list = struct ("axis", {}, "names", {});
  for j = 1:numel (cycles)
    p = gs.drive.motor_and_gear (cycles(j), motors(j), gears(j), [], d.asked.inertia_ratio);
    if (! p.feasible)
      list(end+1) = struct ("axis", j, "names", {p.violated});
    endif
  endfor
endfunction

function text = said (d, broken)
  if (isempty (broken))
    text = "nothing up to 10 times";
    return;
  endif
  text = strjoin (arrayfun (@(b) sprintf ("%s of %s", strjoin (b.names, " and "), ...
                                          d.axes(b.axis).coordinate), broken, ...
                            "UniformOutput", false), ", ");
endfunction

## a tenth more of the limit NAME
function [motor, gear, what] = more_of (motor, gear, name)
  what = name;
  switch (name)
    case "voltage"
      motor.V_max *= 1.1;
    case "thermal"
      motor.dT_max *= 1.1;
    case {"T_peak", "T_cont", "omega_max"}
      motor.(name) *= 1.1;
    case "gear_peak"
      gear.T_peak *= 1.1;
    case "gear_cont"
      gear.T_cont *= 1.1;
    case "gear_speed"
      gear.omega_in_max *= 1.1;
    case "buckling"
      gear.F_buckling *= 1.1;
    case "critical_speed"
      gear.omega_critical *= 1.1;
  endswitch
endfunction
