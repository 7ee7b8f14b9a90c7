## d = gs.machine.tune_loops (who, d)
## The laws of the axes of the design D, tuned one by one with the others locked, and the margins of
## the loops with all others closed: Ms, the largest of each axis over all poses, Ms_at (number of
## the pose), loops (gsmbp_loop there). Where Ms is above what is demanded the axis is tuned anew to
## less, three times at most.

function d = tune_loops (who, d)
  n = numel (d.axes);
  goals = repmat (d.asked.Ms, 1, n);
  [d.laws, which_] = deal (struct ("law", {}, "at", {}, "worst", {}, "tried", {}), 1:n);
  for round_ = 1:4
    d.laws = gs.machine.tune_laws (d.asked, d.axes, d.poses, goals, d.laws, which_);
    Ms = peaks (who, d);
    [d.Ms, d.Ms_at] = max (Ms, [], 2);
    above = d.Ms(:)' - d.asked.Ms;
    which_ = find (above > 0);
    if (isempty (which_) || any (! isfinite (d.Ms)))
      break;
    endif
    goals(which_) = max (goals(which_) - 1.2 * above(which_) - 1e-3, 1.05);
  endfor
  d.goals = goals;
  for j = 1:n
    d.loops(j) = gsmbp_loop (of_pose (who, d, d.Ms_at(j)))(j);
  endfor
endfunction

## a column for each pose
function Ms = peaks (who, d)
  for k = 1:numel (d.poses)
    c = of_pose (who, d, k);
    for j = 1:numel (d.axes)
      Ms(j,k) = gs.machine.resonance_peak (c, j, c.plant);
    endfor
  endfor
endfunction

function c = of_pose (who, d, k)
  c = gs.machine.axis_controllers (who, d.asked, d.axes, d.poses(k), d.laws, ...
                                   Inf (1, numel (d.axes)), false);
endfunction
