## cycles = gs.drive.load_cycles (m, axes_, tasks, n = 201)
## The load cycle of each axis: that of all tasks, one after the other, without what motors and
## gears add, from N times of each. They are taken as they are in the model M.

function cycles = load_cycles (m, axes_, tasks, n = 201)
  parts = cell (numel (tasks), numel (axes_));
  for i = 1:numel (tasks)
    alone = gs.machine.ideal_machine (m, axes_, tasks(i));
    t = linspace (tasks(i).start, tasks(i).stop, n);
    parts(i,:) = gs.drive.axis_loads (alone, axes_, tasks(i).plan, t);
  endfor
  for j = 1:numel (axes_)
    cycles(j) = setfield (behind (parts(:,j)), "coordinate", axes_(j).coordinate);
  endfor
endfunction

## one after the other, at once
function c = behind (parts)
  c = parts{1};
  for k = 2:numel (parts)
    next = parts{k};
    next.t += c.t(end) - next.t(1) + 1e-9 * (c.t(end) - c.t(1));
    for name = {"t", "position", "omega", "alpha", "torque"}
      c.(name{1}) = [c.(name{1}); next.(name{1})];
    endfor
    c.inertia = max (c.inertia, next.inertia);
  endfor
endfunction
