## list = gs.machine.unmet_demands (d)
## What the design D does not meet: a row of structs: axis, name, unit, found, demanded, where (at
## the nominal values, or at which corner), said, a sentence.

function list = unmet_demands (d)
  list = struct ("axis", {}, "name", {}, "unit", {}, "found", {}, "demanded", {}, "where", {}, ...
                 "said", {});
  for j = 1:numel (d.axes)
    if (! (d.Ms(j) <= d.asked.Ms))
      pose = d.poses(d.Ms_at(j));
      where = sprintf ("at the pose of %s at %.4g s%s", pose.task, pose.time, pose.corner);
      list(end+1) = row (d.axes(j).coordinate, "Ms", "1", d.Ms(j), d.asked.Ms, where);
    endif
  endfor
  for one = d.margins
    if (! (one.used <= 1))
      list(end+1) = row (one.axis, one.name, one.unit, one.found, one.limit, "nominally");
    elseif (isfield (one, "worst") && ! isempty (one.worst) && ! (one.worst <= one.limit))
      list(end+1) = row (one.axis, one.name, one.unit, one.worst, one.limit, ...
                         ["at the corner " ...
                          gs.proof.corner_text(d.asked, d.corners(one.corner).signs)]);
    endif
  endfor
endfunction

function r = row (axis_, name, unit, found, demanded, where)
  said = sprintf ("%s of %s: found %.4g %s %s, demanded at most %.4g", name, axis_, found, unit, ...
                  where, demanded);
  r = struct ("axis", axis_, "name", name, "unit", unit, "found", found, "demanded", demanded, ...
              "where", where, "said", strrep (said, " 1 ", " "));
endfunction
