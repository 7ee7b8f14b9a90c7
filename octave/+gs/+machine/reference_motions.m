## references = gs.machine.reference_motions (d)
## What the controller's computer of the design D knows of each task, a cell each: at its
## samples t, also for half a second behind a task that ends at rest, planned, the coordinates,
## and voltages, those that the motion takes by the nominal model while the output of that
## sample acts, from a table of 401 points.

function references = reference_motions (d)
  [s, axes_] = deal (d.asked, d.axes);
  for i = 1:numel (d.tasks)
    task = d.tasks(i);
    last = floor ((task.stop - task.start + 0.5 * task.rests) / s.period + 1e-9);
    r.t = task.start + (0:last)' * s.period;
    within = @(t) max (task.start, min (task.stop, t));
    planned = gsmbp_evaluate (task.plan, within (r.t));
    r.planned = reshape (planned, numel (axes_), numel (r.t))';
    points = linspace (task.start, task.stop, min (401, last + 1))';
    v = gs.proof.motion_command (d.model, axes_, task, points);
    v = v(:,[axes_.input]);
    r.voltages = interp1 (points, v, within (r.t + s.delay + s.period / 2));
    r.voltages = reshape (r.voltages, numel (r.t), numel (axes_));
    references{i} = r;
  endfor
endfunction
