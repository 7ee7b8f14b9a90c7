## tasks = gs.drive.paced_motions (tasks, f)
## The tasks F times as fast.

function tasks = paced_motions (tasks, f)
  for i = 1:numel (tasks)
    p = tasks(i).plan;
    p.breaks = p.breaks(1) + (p.breaks - p.breaks(1)) / f;
    p.coefs = p.coefs .* f .^ (p.order-1:-1:0);
    tasks(i).plan = p;
    tasks(i).stop = p.breaks(end);
  endfor
endfunction
