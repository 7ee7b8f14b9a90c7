## drives = gs.drive.choose_drives (s, cycles)
## What gsmbp_drive says for the load cycle of each axis; order: the pairs that also keep the
## reserve of the specification S, kept: how many keep the limits alone.

function drives = choose_drives (s, cycles)
  warning ("off", "gsmbp:drive", "local");
  for j = 1:numel (cycles)
    gears = {"gears", s.gears};
    if (strcmp (cycles(j).unit, "m"))
      gears = {"screws", s.screws, "support", gs.drive.axis_support(s, cycles(j).coordinate)};
    endif
    if (isfinite (s.inertia_ratio))
      gears = [gears, {"inertia_ratio", s.inertia_ratio}];
    endif
    r = gsmbp_drive (cycles(j), "motors", s.motors, gears{:}, "goal", s.goal);
    r.kept = numel (r.order);
    most = @(k) max (cell2mat (struct2cell (r.pairs(k).utilization)));
    r.order = r.order(arrayfun (most, r.order) <= 1 - s.reserve);
    drives(j) = r;
  endfor
endfunction
