## list = gs.machine.drive_missing (d)
## Axes of the design D for which no pair of the catalogue keeps all limits, as
## gs.machine.unmet_demands says it: the limit of the nearest pair that is missed most.

function list = drive_missing (d)
  list = struct ("axis", {}, "name", {}, "unit", {}, "found", {}, "demanded", {}, "where", {}, ...
                 "said", {});
  for j = 1:numel (d.axes)
    r = d.drives(j);
    if (! isempty (r.order))
      continue;
    endif
    use = {r.pairs.utilization};
    [most, which_] = cellfun (@(u) max (cell2mat (struct2cell (u))), use);
    [least, k] = min (most);
    name = fieldnames (use{k}){which_(k)};
    allowed = 1 - d.asked.reserve;
    said = sprintf (["drive of %s: none of the %d pairs keeps all limits%s; the nearest, %s, " ...
                     "uses %.4g of its %s, demanded at most %.4g"], d.axes(j).coordinate, ...
                    numel (r.pairs), [" and the reserve"](1:16 * (d.asked.reserve > 0)), ...
                    r.pairs(k).name, least, name, allowed);
    list(end+1) = struct ("axis", d.axes(j).coordinate, "name", ["drive: " name], "unit", "1", ...
                          "found", least, "demanded", allowed, "where", r.pairs(k).name, ...
                          "said", said);
  endfor
endfunction
