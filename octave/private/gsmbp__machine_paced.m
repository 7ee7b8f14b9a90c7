## tasks = gsmbp__machine_paced (tasks, f)
## The tasks F times as fast.

function tasks = gsmbp__machine_paced (tasks, f)
  for i = 1:numel (tasks)
    p = tasks(i).plan;
    p.breaks = p.breaks(1) + (p.breaks - p.breaks(1)) / f;
    p.coefs = p.coefs .* f .^ (p.order-1:-1:0);
    tasks(i).plan = p;
    tasks(i).stop = p.breaks(end);
  endfor
endfunction
