## list = gs.machine.list_decisions (d)
## The decisions of the design D, each with its reason: laws and numbers, and what else there was.

function list = list_decisions (d)
  list = struct ("what", {}, "chosen", {}, "why", {}, "alternatives", {});
  for one = d.springs
    list(end+1) = one;
  endfor
  for j = 1:numel (d.axes)
    if (isempty (d.drives(j).order))
      list(end+1) = no_drive (d, j);
    elseif (d.found)
      list(end+1) = drive (d, j);
      list(end+1) = ratio (d, j);
    endif
  endfor
  if (! d.found)
    return;
  endif
  for j = 1:numel (d.axes)
    list(end+1) = gains (d, j);
    list(end+1) = brake (d.axes(j), d.holding(j));
  endfor
  list(end+1) = feedforward (d);
endfunction

function r = decision (what, chosen, why, alternatives)
  r = struct ("what", what, "chosen", chosen, "why", {why}, "alternatives", {alternatives});
endfunction

function r = drive (d, j)
  [a, t] = deal (d.axes(j), d.drives(j));
  pair = t.pairs(d.chosen(j));
  place = find (t.order == d.chosen(j));
  why = {asked_of(d.cycles(j)), ...
         sprintf(["%d of %d pairs of the catalogue keep all limits%s; by %s %s is number %d of " ...
                  "them: %s"], numel (t.order), numel (t.pairs), reserve (d), t.goal, pair.name, ...
                 place, figure_of (pair, t.goal)), ...
         gs.machine.share_text(pair)};
  if (place > 1)
    why{end+1} = sprintf (["those before it were tried as whole machines and did not meet all " ...
                           "demands (%s)"], told (d.attempts(! strcmp ({d.attempts.name}, ...
                                                                       all_names (d)))));
  endif
  other = arrayfun (@(k) sprintf ("%s: %s; %s", t.pairs(k).name, figure_of (t.pairs(k), t.goal), ...
                                  gs.machine.share_text (t.pairs(k))), ...
                    setdiff (t.order, d.chosen(j), "stable")(1:min (5, numel (t.order) - 1)), ...
                    "UniformOutput", false);
  r = decision (["Drive of " a.coordinate], ...
                sprintf ("%s: motor %s, gear %s", pair.name, pair.motor, pair.gear), why, ...
                [better(t, pair), other]);
endfunction

function text = asked_of (c)
  rms = @(x) sqrt (trapz (c.t, x .^ 2) / (c.t(end) - c.t(1)));
  unit = {"N*m", "rad", "kg*m^2"; "N", "m", "kg"}(1 + strcmp (c.unit, "m"),:);
  text = sprintf (["the motion asks for %.4g %s at most, %.4g %s rms, up to %.4g %s/s, %.4g " ...
                   "%s/s^2 rms; inertia up to %.4g %s"], max (abs (c.torque)), unit{1}, ...
                  rms (c.torque), unit{1}, max (abs (c.omega)), unit{2}, rms (c.alpha), unit{2}, ...
                  c.inertia, unit{3});
endfunction

function text = reserve (d)
  text = "";
  if (d.asked.reserve > 0)
    text = sprintf (" with a reserve of %.3g %%", 100 * d.asked.reserve);
  endif
endfunction

function text = figure_of (pair, goal)
  units = struct ("mass", "kg", "energy", "J", "energy_no_recovery", "J", "cost", "", ...
                  "power_peak", "W", "torque_rms", "N*m");
  text = strtrim (sprintf ("%s %.4g %s", goal, pair.(goal), units.(goal)));
endfunction

## pairs that would be better by the goal and break a limit, the three nearest
function list = better (t, chosen)
  list = {};
  bad = find (! [t.pairs.feasible] & [t.pairs.(t.goal)] < chosen.(t.goal));
  most = arrayfun (@(k) max (cell2mat (struct2cell (t.pairs(k).utilization))), bad);
  [~, order] = sort (most);
  for k = bad(order(1:min (3, end)))
    list{end+1} = sprintf ("%s: %s, but it breaks %s (%s)", t.pairs(k).name, ...
                           figure_of (t.pairs(k), t.goal), ...
                           strjoin (t.pairs(k).violated, ", "), gs.machine.share_text (t.pairs(k)));
  endfor
endfunction

function text = all_names (d)
  list = arrayfun (@(j) d.drives(j).pairs(d.chosen(j)).name, 1:numel (d.axes), ...
                   "UniformOutput", false);
  text = strjoin (list, ", ");
endfunction

function text = told (attempts)
  text = strjoin (arrayfun (@(one) sprintf ("%s: %s", one.name, ...
                                            strjoin ({one.unmet.said}, "; ")), attempts, ...
                            "UniformOutput", false), ". ");
endfunction

function r = ratio (d, j)
  t = d.drives(j);
  pair = t.pairs(d.chosen(j));
  law = t.motors(strcmp ({t.motors.name}, pair.motor));
  why = {law.said, ...
         sprintf(["the catalogue has steps: of the gears of this motor that keep all limits %s " ...
                  "has the best %s of a pair that was proven"], pair.gear, t.goal)};
  if (isfinite (pair.inertia_ratio))
    why{end+1} = sprintf ("load : motor inertia, seen by the motor: %.4g", pair.inertia_ratio);
  endif
  same = find (strcmp ({t.pairs.motor}, pair.motor));
  same = setdiff (same, d.chosen(j));
  [~, order] = sort (abs (log ([t.pairs(same).ratio] / pair.ratio)));
  other = {};
  for k = same(order(1:min (4, end)))
    p = t.pairs(k);
    verdict = "keeps all limits";
    if (! p.feasible)
      verdict = ["breaks " strjoin(p.violated, ", ")];
    endif
    other{end+1} = sprintf ("n = %g (%s): %s; rms torque %.4g N*m; %s", p.ratio, p.gear, ...
                            verdict, p.torque_rms, gs.machine.share_text (p));
  endfor
  r = decision (["Gear ratio of " d.axes(j).coordinate], sprintf ("n = %g", pair.ratio), why, ...
                other);
endfunction

function r = no_drive (d, j)
  t = d.drives(j);
  r = decision (["Drive of " d.axes(j).coordinate], "none", ...
                {asked_of(d.cycles(j)), d.unmet(strcmp ({d.unmet.axis}, d.axes(j).coordinate)) ...
                 .said}, {});
endfunction

function r = gains (d, j)
  [law, a] = deal (d.laws(j), d.axes(j));
  c = law.law;
  pose = d.poses(law.at);
  worst = d.loops(j);
  why = {["u = Kp*(r - y) + Ki*integral(r - y) + Kd*rate(r - y), the rate with the lag Tf; it " ...
          "reads " a.output " and gives " a.motor ".v"], ...
         sprintf("every %.4g ms, its output comes %.4g ms later; both are in the loop exactly", ...
                 1e3 * d.asked.period, 1e3 * d.asked.delay), ...
         sprintf(["the largest gain with max |1/(1 + L)| = Ms at most %.4g, the other axes " ...
                  "locked, at the pose of %s at %.4g s%s; over all %d poses%s it is at most " ...
                  "%.4g"], ...
                 d.goals(j), pose.task, pose.time, pose.corner, numel (d.poses), corners (d), ...
                 law.worst), ...
         sprintf(["with the loops of all axes closed, over all poses: Ms at most %.4g; there " ...
                  "phase margin %.3g degrees, gain margin %.3g, delay margin %.3g ms"], d.Ms(j), ...
                 abs (worst.phase) * 180 / pi, worst.gain, 1e3 * worst.delay), ...
         ["dry friction and losses of gears are left out of the linear model: at rest they " ...
          "would pretend damping; the runs have them"]};
  if (any (law.tried(:,3) > c.Ki * 1.01))
    why{end+1} = sprintf (["the integral is slower, Ti = %.4g s, than one pose alone would " ...
                           "bear: one law has to do for all poses"], c.Ti);
  endif
  if (isfield (d, "Ms_corners"))
    why{end+1} = sprintf ("at the corners of the tolerances, at that pose: Ms at most %.4g", ...
                          max (d.Ms_corners(j,:)));
  endif
  other = {};
  for row = law.tried(law.tried(:,2) != c.Kp,:)'
    other{end+1} = sprintf (["gains of the pose of %s at %.4g s, Kp %.4g, Ki %.4g, Kd %.4g: Ms " ...
                             "up to %.4g, at %.4g s of %s"], d.poses(row(1)).task, ...
                            d.poses(row(1)).time, row(2:5), d.poses(row(6)).time, ...
                            d.poses(row(6)).task);
  endfor
  r = decision (["Controller of " a.coordinate], ...
                sprintf ("PID: Kp = %.5g, Ki = %.5g, Kd = %.5g, Tf = %.4g s", c.Kp, c.Ki, c.Kd, ...
                         c.Tf), why, other);
endfunction

function text = corners (d)
  text = "";
  if (d.asked.Ms_corners && ! isempty (d.asked.tolerances))
    text = ", those at all corners of the tolerances among them,";
  endif
endfunction

## what holds the axis where the motor has no current
function r = brake (a, h)
  unit = {"N*m", "N"}{1 + strcmp(a.unit, "m")};
  if (h.torque > 0 && ! h.locks)
    chosen = sprintf ("at the motor, with a holding torque of at least %.4g N*m", h.torque);
    why = sprintf (["at rest %.4g %s load it at most%s, without current they would move it; " ...
                    "losses and dry friction that help to hold it are not counted"], h.load, ...
                   unit, h.where);
  elseif (h.locks)
    chosen = "none needed";
    why = sprintf (["at rest %.4g %s load it at most%s, and the gear or screw locks itself " ...
                    "(its efficiency backward is not above 0)"], h.load, unit, h.where);
  else
    chosen = "none needed";
    why = "at rest nothing loads it along the tasks";
  endif
  r = decision (["Brake of " a.coordinate], chosen, {why}, {});
endfunction

function r = feedforward (d)
  off = @(list) strjoin (arrayfun (@error_of, list(strcmp ({list.name}, "tracking error")), ...
                                   "UniformOutput", false), ", ");
  if (d.feedforward)
    r = decision ("Feedforward", "yes: the voltages of the motion, from the inverse model", ...
                  {["without it the accuracy is not kept: " off(d.plain)], ...
                   ["with it: " off(d.margins)], ...
                   ["the computer takes them from a table of the nominal model, as the " ...
                    "references"]}, {});
  else
    r = decision ("Feedforward", "no", ...
                  {["the accuracy is kept without it: " off(d.margins)]}, {});
  endif
endfunction

function text = error_of (one)
  text = sprintf ("%s %.4g %s", one.axis, one.found, one.unit);
  if (isfield (one, "worst") && ! isempty (one.worst))
    text = sprintf ("%s, at a corner %.4g %s", text, one.worst, one.unit);
  endif
endfunction
