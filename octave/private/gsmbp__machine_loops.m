## d = gsmbp__machine_loops (who, d)
## The laws of the axes of the design D, tuned one by one with the others locked, and the
## margins of the loops with all others closed at all poses: Ms, the largest of each axis. Where
## these are above what is demanded the laws are tuned anew to less, three times at most.

function d = gsmbp__machine_loops (who, d)
  n = numel (d.axes);
  goals = repmat (d.asked.Ms, 1, n);
  for round_ = 1:4
    d.laws = gsmbp__machine_tuned (d.asked, d.axes, d.poses, goals);
    d.loops = of_all (who, d);
    [d.Ms, d.Ms_at] = max (reshape ([d.loops.Ms], n, []), [], 2);
    above = d.Ms(:)' - d.asked.Ms;
    if (all (above <= 0) || any (! isfinite (d.Ms)))
      break;
    endif
    goals = max (goals - 1.2 * max (above, 0) - 1e-3 * (above > 0), 1.05);
  endfor
  d.goals = goals;
endfunction

## a column for each pose; unstable ones have an infinite Ms
function loops = of_all (who, d)
  for k = 1:numel (d.poses)
    c = gsmbp__machine_controller (who, d.asked, d.axes, d.poses(k), d.laws, Inf (1, ...
                                   numel (d.axes)), false);
    loops(:,k) = gsmbp_loop (c)(:);
    if (max (abs (gsmbp__closed_poles (c))) >= 1)
      [loops(:,k).Ms] = deal (Inf);
    endif
  endfor
endfunction
