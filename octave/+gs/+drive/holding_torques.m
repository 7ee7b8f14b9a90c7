## holding = gs.drive.holding_torques (d)
## What holds each axis of the design D where its motor has no current, a row of structs: axis, load
## (the largest at rest, nominally and at the corners that were run), torque (of a brake at the
## motor; 0 where no load is there), locks (the gear or screw locks itself), where (the corner in
## words).

function holding = holding_torques (d)
  loads = d.proof.rest;
  for one = d.corners
    loads(:,end+1) = one.proof.rest;
  endfor
  for j = 1:numel (d.axes)
    [load_, k] = max (loads(j,:));
    where = "";
    if (k > 1)
      where = [" (at the corner " gs.proof.corner_text(d.asked, d.corners(k-1).signs) ")"];
    endif
    some = load_ > 1e-6 * max (abs (d.cycles(j).torque));
    holding(j) = struct ("axis", d.axes(j).coordinate, "load", load_, "torque", ...
                         some * load_ / d.gears(j).ratio, "locks", ...
                         some && d.gears(j).eta_back <= 0, "where", where);
  endfor
endfunction
