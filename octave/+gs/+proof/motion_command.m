## [v, x] = gs.proof.motion_command (m, axes_, task, t)
## Voltages and states of the model M along a task at the times T (within it), rows; the inductance
## of motors is left out where the motion has a jump in its acceleration (i = (v - K*n*w)/R then).

function [v, x] = motion_command (m, axes_, task, t)
  side = 1 - 2 * (t(:) == task.stop);
  m = gsmbp_set (m, task.values);
  [v, x] = deal (zeros (numel (t), m.sizes.nv), zeros (numel (t), m.sizes.nx));
  for way = [1, -1]
    k = side == way;
    if (any (k))
      r = along (m, task, t(k), way);
      [v(k,:), x(k,:)] = deal (r.v, r.x);
    endif
  endfor
  for a = axes_
    p = m.par;
    i = (v(:,a.input) - p.(a.par.K) * p.(a.par.n) * x(:,m.sizes.nq + a.k)) / p.(a.par.R);
    none = isnan (x(:,a.state));
    x(none,a.state) = i(none);
  endfor
endfunction

function r = along (m, task, t, way)
  try
    r = gsmbp_inverse (m, task.plan, t, "side", way);
  catch
    r = gsmbp_inverse (m, task.plan, t, "side", way, "quasistatic", true);
  end_try_catch
endfunction
