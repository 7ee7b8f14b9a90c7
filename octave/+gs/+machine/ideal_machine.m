## m = gs.machine.ideal_machine (m, axes_, task)
## The model M with the values of the TASK, without what the motors and gears of the axes add.

function m = ideal_machine (m, axes_, task)
  none = struct ();
  for a = axes_
    for letter = {"J", "B", "Tc", "Jg"}
      if (isfield (m.par, a.par.(letter{1})))
        none.(a.par.(letter{1})) = 0;
      endif
    endfor
  endfor
  m = gsmbp_set (gsmbp_set (m, task.values), none);
endfunction
