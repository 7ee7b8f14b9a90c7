## cycles = gsmbp__machine_cycles (m, axes_, tasks, n = 201)
## The load cycle of each axis: that of all tasks, one after the other, without what motors and
## gears add, from N times of each. They are taken as they are in the model M.

function cycles = gsmbp__machine_cycles (m, axes_, tasks, n = 201)
  warning ("off", "gsmbp:drive", "local");
  none = struct ();
  for a = axes_
    for letter = {"J", "B", "Tc", "Jg"}
      if (isfield (m.par, a.par.(letter{1})))
        none.(a.par.(letter{1})) = 0;
      endif
    endfor
  endfor
  parts = cell (numel (tasks), numel (axes_));
  for i = 1:numel (tasks)
    one = tasks(i);
    alone = gsmbp_set (gsmbp_set (m, one.values), none);
    t = linspace (one.start, one.stop, n);
    r = gsmbp_inverse (alone, one.plan, t, "quasistatic", true);
    for j = 1:numel (axes_)
      parts{i,j} = gsmbp_cycle (alone, r, axes_(j).coordinate);
    endfor
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
