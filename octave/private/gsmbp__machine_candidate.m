## d = gsmbp__machine_candidate (who, d, places)
## The design D with the pair at PLACES(j) of the order of axis j: parameters, controller, machine
## with it, runs, corners; feedforward where the accuracy is not kept without it. Adds what was not
## met.

function d = gsmbp__machine_candidate (who, d, places)
  for j = 1:numel (d.axes)
    d.chosen(j) = d.drives(j).order(places(j));
    pair = d.drives(j).pairs(d.chosen(j));
    list = d.drives(j).catalogues;
    d.motors(j) = list.motors(strcmp ({list.motors.name}, pair.motor));
    d.gears(j) = list.gears(strcmp ({list.gears.name}, pair.gear));
  endfor
  d.values = gsmbp__machine_values (d.model, d.axes, d.drives, d.chosen);
  d.model = gsmbp_set (d.model, d.values);
  d.poses = gsmbp__machine_poses (d.model, d.axes, d.tasks, d.asked, []);
  if (d.asked.Ms_corners)
    for signs = gsmbp__machine_signs (rows (d.asked.tolerances))'
      d.poses = [d.poses, gsmbp__machine_poses(d.model, d.axes, d.tasks, d.asked, signs')];
    endfor
  endif
  d.references = gsmbp__machine_references (d);
  d = gsmbp__machine_loops (who, d);
  d.plain = [];
  d.derivatives = "";
  d = proven (who, d, false);
  if (any (strcmp ({d.unmet.name}, "tracking error")))
    d.plain = d.margins;
    d = proven (who, d, true);
  endif
endfunction

function d = proven (who, d, feedforward)
  d.feedforward = feedforward;
  [d.controller, d.machine, d.smooth] = gsmbp__machine_built (who, d, d.laws, feedforward);
  d.proof = gsmbp__machine_proof (d, struct ());
  d.margins = d.proof.measures;
  d.unmet = gsmbp__machine_unmet (d);
  if (isempty (d.unmet) || feedforward)
    d = gsmbp__machine_corners (d);
    d.unmet = gsmbp__machine_unmet (d);
  endif
endfunction
