## Ms = gs.proof.loops_at (d, changes)
## Ms of the loops of all axes (rows) of the design D at the corners CHANGES (a row each, shares
## of the parameters with tolerances), at the pose that is worst for the axis nominally, all
## loops closed.

function Ms = loops_at (d, changes)
  names = d.asked.tolerances(:,1)';
  inputs = d.model.inputs([d.axes.input]);
  Ms = zeros (numel (d.axes), rows (changes));
  for j = 1:numel (d.axes)
    pose = d.poses(d.Ms_at(j));
    for k = 1:rows (changes)
      one = pose;
      for i = 1:numel (names)
        one.model = gsmbp_set (one.model, names{i}, pose.model.par.(names{i}) ...
                                                    * (1 + changes(k,i)));
      endfor
      one.trim = gsmbp_trim (one.model, pose.trim.x, pose.trim.v, "hold", {d.axes.coordinate}, ...
                             "free", inputs);
      c = gs.machine.axis_controllers ("gsmbp_design", d.asked, d.axes, one, d.laws, ...
                                       Inf (1, numel (d.axes)), false);
      Ms(j,k) = gs.machine.resonance_peak (c, j, c.plant);
    endfor
  endfor
endfunction
