## d = gs.machine.design_candidate (who, d, places)
## The design D with the pair at PLACES(j) of the order of axis j: parameters, controller, machine
## with it, runs, corners; feedforward where the accuracy is not kept without it. Adds what was not
## met.

function d = design_candidate (who, d, places)
  for j = 1:numel (d.axes)
    d.chosen(j) = d.drives(j).order(places(j));
    pair = d.drives(j).pairs(d.chosen(j));
    list = d.drives(j).catalogues;
    d.motors(j) = list.motors(strcmp ({list.motors.name}, pair.motor));
    d.gears(j) = list.gears(strcmp ({list.gears.name}, pair.gear));
  endfor
  d.values = gs.machine.chosen_values (d.model, d.axes, d.drives, d.chosen);
  d.model = gsmbp_set (d.model, d.values);
  d.poses = gs.machine.work_poses (d.model, d.axes, d.tasks, d.asked, []);
  if (d.asked.Ms_corners)
    for signs = gs.proof.corner_signs (rows (d.asked.tolerances))'
      d.poses = [d.poses, gs.machine.work_poses(d.model, d.axes, d.tasks, d.asked, signs')];
    endfor
  endif
  d.references = gs.machine.reference_motions (d);
  d = gs.machine.tune_loops (who, d);
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
  [d.controller, d.machine, d.smooth] = gs.machine.build_controller (who, d, d.laws, feedforward);
  d.proof = gs.proof.prove_at (d, struct ());
  d.margins = d.proof.measures;
  d.unmet = gs.machine.unmet_demands (d);
  if (isempty (d.unmet) || feedforward)
    d = gs.proof.all_corners (d);
    d.unmet = gs.machine.unmet_demands (d);
  endif
endfunction
