## job = gs.plan.reach_job (who, m, name, k, turned, options)
## What gsmbp_reach is asked for K poses, checked: tool (number of the point), whole (axes are given
## too: TURNED), closed (by IKN), rows (of q that IKN gives), given (a column for each pose), start,
## limits, time, branch.

function job = reach_job (who, m, name, k, turned, options)
  nq = m.sizes.nq;
  job.tool = find (strcmp (name, m.points));
  if (isempty (job.tool))
    error ("%s: unknown point %s", who, gs.text.nearest_word (name, m.points));
  endif
  frame = strcmp (m.json.points(job.tool).kind, "frame");
  if (turned && ! frame)
    error ("%s: %s is a point, not a frame: expected its place alone, without axes", who, name);
  endif
  job.whole = turned;
  alone = frame && ! turned;   # a place without axes: IKN does not know it
  [job.closed, job.rows, order] = by_formula (who, m, name, options, alone);
  job.given = given_values (who, m, k, order, options.given, job.closed);
  if (! job.closed && ! is_emitted (m, "nik"))
    error (["%s: %s%s has no closed form here: emit the model with the request reach", ...
            "%s"], who, {"", "the place of "}{1 + alone}, name, ...
           {sprintf(" (or inverse_kinematics(%s))", name), " (or give the axes)"}{1 + alone});
  endif
  job.start = options.start;
  if (isempty (job.start))
    job.start = m.initial(1:nq);
  endif
  job.start = gs.given.given_vector (who, "option start", job.start, nq, "", m.coordinates);
  job.limits = options.limits;
  if (isempty (job.limits))
    job.limits = max (min (gs.model.scene_limits (m, m.coordinates), 1e300), -1e300);
  elseif (! isequal (size (job.limits), [nq, 2]))
    error ("%s: option limits: expected %d x 2 numbers, found %d x %d", who, nq, ...
           rows (job.limits), columns (job.limits));
  elseif (any (job.limits(:,1) > job.limits(:,2)))
    k = find (job.limits(:,1) > job.limits(:,2), 1);
    error ("%s: option limits: %s: the least, %g, is above the largest, %g", who, ...
           m.coordinates{k}, job.limits(k,:));
  endif
  job.turns = strcmp ({m.json.coordinates.unit}', "rad");
  job.time = options.time;
  job.branch = options.branch;
  if (job.branch > 0 && ! job.closed)
    error ("%s: option branch: %s is not reached by a closed form here, which has branches", ...
           who, name);
  endif
endfunction

## whether IKN was emitted for this tool; the places in q of what it gives; what is given to it
function [closed, places, names] = by_formula (who, m, name, options, alone)
  [closed, places, names] = deal (false, [], {});
  if (alone && strcmp (options.method, "closed"))
    error ("%s: option method: IKN of %s takes its axes too: expected R", who, name);
  elseif (alone || strcmp (options.method, "newton"))
    return;
  endif
  if (isfield (m.json, "reach") && strcmp (m.json.reach.tool, name) && is_emitted (m, "ikn"))
    closed = numel (m.json.reach.chains) == 1;
    if (! isempty (m.json.reach.given))
      names = cellstr (m.json.reach.given)(:)';
    endif
  endif
  if (closed)
    [~, places] = ismember (cellstr (m.json.reach.chains(1).coordinates), m.coordinates);
  elseif (strcmp (options.method, "closed"))
    error (["%s: option method: IKN was not emitted for %s (request inverse_kinematics(%s)),", ...
            " or the chain is closed"], who, name, name);
  endif
endfunction

function v = given_values (who, m, k, names, v, closed)
  n = closed * numel (names);
  if (n == 0)
    if (! isempty (v))
      error ("%s: option given: no coordinate of this model is given", who);
    endif
  elseif (rows (v) != n || (n > 0 && ! any (columns (v) == [1, k])))
    error ("%s: option given: expected a value of %s, one column or %d, found %d x %d", who, ...
           strjoin (names, ", "), k, rows (v), columns (v));
  elseif (columns (v) == 1)
    v = repmat (v, 1, k);
  endif
endfunction

function yes = is_emitted (m, word)
  names = cellstr ({m.json.subroutines.name});
  yes = any (strcmpi (names, [m.name "_" word]));
endfunction
