## d = gs.machine.attempt_designs (who, d)
## The first choice of drives for the design D with which all demands are met, of those in the
## order of the goal; where none of the first few is, the one that misses least. Adds attempts
## (a row of structs: name of the drives, unmet) and found: whether there was any pair.

function d = attempt_designs (who, d)
  d.cycles = gs.drive.load_cycles (d.model, d.axes, d.tasks);
  d.drives = gs.drive.choose_drives (d.asked, d.cycles);
  d.attempts = struct ("name", {}, "unmet", {});
  counts = arrayfun (@(r) numel (r.order), d.drives);
  d.found = all (counts > 0);
  if (! d.found)
    d.unmet = gs.machine.drive_missing (d);
    return;
  endif
  places = ones (1, numel (d.axes));
  [best, start] = deal ([], d);
  for k = 1:d.asked.tries
    one = tried (who, start, places);
    names = arrayfun (@(j) start.drives(j).pairs(start.drives(j).order(places(j))).name, ...
                      1:numel (start.axes), "UniformOutput", false);
    one.attempts(end+1) = struct ("name", strjoin (names, ", "), "unmet", one.unmet);
    start.attempts = one.attempts;
    if (isempty (best) || missed (one) < missed (best))
      best = one;
    endif
    next = ismember ({one.axes.coordinate}, {one.unmet.axis}) & places < counts;
    if (! any (next))
      break;
    endif
    places += next;
  endfor
  best.attempts = start.attempts;
  d = best;
endfunction

## one that cannot be controlled is not found
function d = tried (who, d, places)
  try
    d = gs.machine.design_candidate (who, d, places);
  catch problem
    if (! strcmp (problem.identifier, "gsmbp:untuned"))
      rethrow (problem);
    endif
    said = sprintf (["controller of %s: no gain of a PID controller sampled every %.4g s, " ...
                     "delay %.4g s, has Ms at most %.4g"], problem.message, d.asked.period, ...
                    d.asked.delay, d.asked.Ms);
    d.found = false;
    d.unmet = struct ("axis", problem.message, "name", "controller", "unit", "1", "found", Inf, ...
                      "demanded", d.asked.Ms, "where", "nominally", "said", said);
  end_try_catch
endfunction

function x = missed (d)
  x = sum (max (0, [d.unmet.found] ./ [d.unmet.demanded] - 1)) + numel (d.unmet);
endfunction
