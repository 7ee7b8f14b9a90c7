## laws = gs.machine.tune_laws (s, axes_, poses, goals, laws, which_)
## A PID controller for each axis j: tuned to the largest sensitivity GOALS(j) at the first
## pose, then at the one where these gains are worst, until the gains keep it at all poses;
## where no pose gives such gains, with a slower integral. A row of structs: law (of gsmbp_pid),
## at (number of the pose), worst (its largest Ms), tried (a row for each: pose, Kp, Ki, Kd,
## largest Ms, its pose). WHICH_: the axes that are tuned, the others keep their LAWS; one without
## such gains is the error gsmbp:untuned with its name.

function laws = tune_laws (s, axes_, poses, goals, laws, which_)
  for j = which_
    plants = cell (1, numel (poses));
    for k = 1:numel (poses)
      plants{k} = gs.machine.axis_plant (poses(k), axes_, j);
    endfor
    one = one_axis (s, plants, goals(j));
    if (isempty (one.law))
      error ("gsmbp:untuned", "%s", axes_(j).coordinate);
    endif
    laws(j) = one;
  endfor
endfunction

## tuned to a little less, so that other poses may differ by rounding
function best = one_axis (s, plants, goal)
  best = struct ("law", [], "at", 0, "worst", Inf, "tried", zeros (0, 6));
  best = at_poses (s, plants, goal, {}, best);
  [Ti, Td] = deal (20 * s.period, 5 * s.period);
  if (! isempty (best.law))
    [Ti, Td] = deal (best.law.Ti, best.law.Td);
  endif
  for slower = 1.5 .^ (1:8)
    if (best.worst <= goal)
      return;
    endif
    best = at_poses (s, plants, goal, {"Ti", Ti * slower, "Td", Td}, best);
  endfor
endfunction

function best = at_poses (s, plants, goal, times, best)
  at = 1;
  tried = zeros (0, 6);
  while (! any (tried(:,1) == at))
    try
      c = gsmbp_pid (plants{at}, [], "pid", "ms", 1 + 0.995 * (goal - 1), times{:}, "bd", 1, ...
                     "period", s.period, "delay", s.delay);
    catch problem
      if (! strncmp (problem.message, "gsmbp_pid: no gain", 18))
        rethrow (problem);
      endif
      break;
    end_try_catch
    Ms = cellfun (@(sys) gs.machine.resonance_peak (c, 1, sampled (sys, s)), plants);
    [worst, next] = max (Ms);
    tried(end+1,:) = [at, c.Kp, c.Ki, c.Kd, worst, next];
    if (worst < best.worst || isempty (best.law))
      [best.law, best.at, best.worst] = deal (c, at, worst);
    endif
    if (worst <= goal)
      break;
    endif
    at = next;
  endwhile
  best.tried = [best.tried; tried];
endfunction

function plant = sampled (sys, s)
  p = struct ("A", sys.a, "B", sys.b, "C", sys.c, "driven", {sys.inname}, "states", ...
              {sys.stname}, "measured", {sys.outname});
  o = struct ("period", s.period, "delay", s.delay);
  p = gs.control.sampled_plant ("gsmbp_design", p, o);
  plant = p.plant;
endfunction
