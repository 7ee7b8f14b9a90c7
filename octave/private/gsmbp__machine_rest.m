## loads = gsmbp__machine_rest (m, axes_, tasks)
## The largest load of each axis at rest, a column: what springs and weight ask of its drive at 21
## poses of each task of the model M, without dry friction.

function loads = gsmbp__machine_rest (m, axes_, tasks)
  loads = zeros (numel (axes_), 1);
  for one = tasks
    for t = linspace (one.start, one.stop, 21)
      q = gsmbp_evaluate (one.plan, t);
      still = setfield (one, "plan", mkpp ([0, 1], q(:), numel (q)));
      [still.start, still.stop] = deal (0, 1);
      c = gsmbp__machine_cycles (m, axes_, still, 2);
      loads = max (loads, arrayfun (@(c) max (abs (c.torque)), c)(:));
    endfor
  endfor
endfunction
