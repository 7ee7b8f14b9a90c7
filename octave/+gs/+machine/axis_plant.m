## sys = gs.machine.axis_plant (pose, axes_, j)
## The linear model of axis j at a pose from its voltage to its coordinate (ss), the other axes
## locked: row j of the equations of motion alone.

function sys = axis_plant (pose, axes_, j)
  m = pose.model;
  [all_, ~, states] = gsmbp_linear (m, 0, pose.trim.x, pose.trim.v);
  a = axes_(j);
  out = strcmp (all_.outname, a.output);
  [A, B, C] = deal (all_.a, all_.b(:,a.input), all_.c(out,:));
  others = axes_([1:j-1, j+1:end]);
  if (! isempty (others))
    u = m.sizes.nq + (1:m.sizes.nu);
    M = m.mas (0, pose.trim.x(1:m.sizes.nq));
    gone = [[others.k], m.sizes.nq + [others.k], [others.state]];
    free = setdiff (1:m.sizes.nu, [others.k]);
    row = M(free,:) * A(u,:);
    A(u(free),:) = M(free,free) \ row;
    keep = setdiff (1:m.sizes.nx, gone);
    B(u(free)) = M(free,free) \ (M(free,:) * B(u));
    [A, B, C, states] = deal (A(keep,keep), B(keep), C(keep), states(keep));
  endif
  sys = ss (A, B, C, 0, "statename", m.states(states), "inputname", m.inputs{a.input}, ...
            "outputname", a.output);
endfunction
