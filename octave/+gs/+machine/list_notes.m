## notes = gs.machine.list_notes (d)
## What the design D did not look at, a cell array of sentences.

function notes = list_notes (d)
  notes = {["runs show the motions and corners that were run, nothing between: a corner that " ...
            "is worse than those, a motion that was not asked for, may exist"], ...
           stability(d), ...
           ["masses of motors and gears on moving links, and their elasticity, unless the " ...
            "scene has them"]};
  if (d.found)
    notes = [notes, screws(d)];
  endif
  for a = d.axes
    if (isempty (a.gear))
      notes{end+1} = sprintf (["%s: no lossy_gear in the scene: the efficiency of the gear is " ...
                               "in the choice of the drive, not in the runs"], a.coordinate);
    endif
  endfor
endfunction

function text = stability (d)
  if (d.asked.Ms_corners)
    text = ["Ms is demanded at the poses that were looked at, nominally and at all corners of " ...
            "the tolerances, not between"];
  else
    text = ["Ms is demanded of the nominal machine; at the corners it is reported, at the pose " ...
            "that is worst nominally (option Ms_corners demands it there)"];
  endif
endfunction

## screws whose length or root diameter is not known
function notes = screws (d)
  notes = {};
  for j = find (strcmp ({d.axes.unit}, "m"))
    if (! isfinite (d.gears(j).F_buckling))
      notes{end+1} = sprintf (["%s: buckling and critical speed of the screw: give its length " ...
                               "and ends (option support) and its root diameter (d_root in the " ...
                               "catalogue)"], d.axes(j).coordinate);
    endif
  endfor
endfunction
