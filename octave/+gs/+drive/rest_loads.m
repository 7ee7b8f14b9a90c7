## loads = gs.drive.rest_loads (m, axes_, tasks)
## The largest load of each axis at rest, a column: what springs and weight ask of its drive at 21
## poses of each task of the model M, without dry friction.

function loads = rest_loads (m, axes_, tasks)
  loads = zeros (numel (axes_), 1);
  for one = tasks
    alone = gs.machine.ideal_machine (m, axes_, one);
    for q = gsmbp_evaluate (one.plan, linspace (one.start, one.stop, 21))
      c = gs.drive.axis_loads (alone, axes_, mkpp ([0, 1], q, numel (q)), 0);
      loads = max (loads, cellfun (@(c) abs (c.torque), c)(:));
    endfor
  endfor
endfunction
