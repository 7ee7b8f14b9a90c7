## d = gs.machine.more_options (d)
## What would have to change to get more of the design D, or to get it at all: d.more, a row of
## structs: what, axis, value, said (a sentence with the numbers).

function d = more_options (d)
  d.more = struct ("what", {}, "axis", {}, "value", {}, "said", {});
  if (! d.found)
    for j = find (arrayfun (@(r) isempty (r.order), d.drives))
      d.more = [d.more, missing(d, j)];
    endfor
    return;
  endif
  d.more = [gs.machine.faster_ways(d), tracking(d), tolerances(d)];
endfunction

function r = item (what, axis_, value, said)
  r = struct ("what", what, "axis", axis_, "value", value, "said", said);
endfunction

## no pair: how slow would do, and with what supply
function list = missing (d, j)
  name = d.axes(j).coordinate;
  list = item ({}, {}, {}, {});
  slow = gs.drive.largest_true (@(f) any_pair (d, j, f), 0.05, 1);
  if (slow > 0)
    c = gs.drive.load_cycles (d.model, d.axes, gs.drive.paced_motions (d.tasks, slow), 101);
    c = c(j);
    best = gs.drive.choose_drives (d.asked, c);
    list(end+1) = item ("speed", name, slow, sprintf (["%s: the motion at %.3g of its speed: " ...
                                                       "then %s keeps all limits"], name, slow, ...
                                                      best.pairs(best.order(1)).name));
  else
    list(end+1) = item ("speed", name, 0, sprintf (["%s: a slower motion does not help: even " ...
                                                    "at a twentieth of its speed no pair keeps " ...
                                                    "all limits"], name));
  endif
  free = d.asked;
  [free.motors.V_max, free.motors.T_peak] = deal (Inf);
  r = gs.drive.choose_drives (free, d.cycles(j));
  if (! isempty (r.order))
    p = r.pairs(r.order(1));
    list(end+1) = item ("supply", name, p.voltage_max, ...
                        sprintf (["%s: without limits of voltage and peak torque %s would do, " ...
                                  "with %.4g V and %.4g A"], name, p.name, p.voltage_max, ...
                                 p.current_peak));
  endif
endfunction

function yes = any_pair (d, j, f)
  c = gs.drive.load_cycles (d.model, d.axes, gs.drive.paced_motions (d.tasks, f), 101);
  drives = gs.drive.choose_drives (d.asked, c(j));
  yes = ! isempty (drives.order);
endfunction

## half the period and delay; encoders without steps: by runs
function list = tracking (d)
  quick = d;
  [quick.asked.period, quick.asked.delay] = deal (d.asked.period / 2, d.asked.delay / 2);
  list = tried (d, quick, "sampling", sprintf (["sampled every %.4g ms with a delay of %.4g ms " ...
                                                "and tuned anew"], 1e3 * quick.asked.period, ...
                                               1e3 * quick.asked.delay));
  if (d.asked.encoder > 0)
    fine = d;
    fine.asked.encoder = 0;
    list = [list, tried(d, fine, "encoder", "with encoders without steps")];
  endif
endfunction

function list = tried (d, other, what, said)
  if (other.asked.period != d.asked.period)
    other.references = gs.machine.reference_motions (other);
    other = gs.machine.tune_loops ("gsmbp_design", other);
  endif
  [~, other.machine] = gs.machine.build_controller ("gsmbp_design", other, other.laws, ...
                                                    d.feedforward);
  p = gs.proof.prove_at (other, struct ());
  list = item ({}, {}, {}, {});
  own = @(m) m(strcmp ({m.name}, "tracking error"));
  [now, then] = deal (own (d.proof.measures), own (p.measures));
  for j = 1:numel (d.axes)
    list(j) = item (what, d.axes(j).coordinate, then(j).found, ...
                    sprintf ("%s: %s the tracking error is %.4g %s instead of %.4g", ...
                             d.axes(j).coordinate, said, then(j).found, then(j).unit, ...
                             now(j).found));
  endfor
endfunction

## for the quantity of each axis that is used most at its corner: the parameter that does it
function list = tolerances (d)
  list = item ({}, {}, {}, {});
  if (isempty (d.corners))
    return;
  endif
  [names, shares] = deal (d.asked.tolerances(:,1), [d.asked.tolerances{:,2}]);
  for j = 1:numel (d.axes)
    own = d.margins(strcmp ({d.margins.axis}, d.axes(j).coordinate));
    [~, k] = max ([own.worst] ./ [own.limit]);
    one = own(k);
    parts = abs (one.slope) .* shares;
    [most, at] = max (parts);
    list(j) = item ("tolerance", one.axis, one.first - most / 2, ...
                    sprintf (["%s: nearest to its limit under tolerances is %s, %.4g of %.4g " ...
                              "%s; of this %s brings %.4g: half its tolerance (%.3g %%) would " ...
                              "leave %.4g to first order"], one.axis, one.name, ...
                              one.worst, one.limit, ...
                             one.unit, names{at}, most, 50 * shares(at), one.first - most / 2));
  endfor
endfunction
