## one = gs.plan.reach_pose (who, m, job, P, R, k, before)
## One pose of gsmbp_reach: q, status, distance, branch, solutions, free; before: the coordinates
## of the pose before.

function one = reach_pose (who, m, job, P, R, k, before)
  one = struct ("q", NaN (m.sizes.nq, 1), "status", "ok", "distance", [0; 0], "branch", 0, ...
                "solutions", zeros (m.sizes.nq, 0), "free", zeros (m.sizes.nu, 1));
  if (job.closed)
    one = by_formula (who, m, job, P, R, k, before, one);
  else
    [q, one.distance, info] = m.nik (job.time, job.tool, job.whole, P, R, before, ...
                                     job.limits(:,1), job.limits(:,2));
    if (info == 0)
      one.q = q;
      one.solutions = q;
    else
      one.status = "unreachable";
    endif
  endif
  if (any (strcmp (one.status, {"ok", "singular"})))
    one = with_free (m, job, one);
  endif
endfunction

## of all solutions within the limits the one closest to that before
function one = by_formula (who, m, job, P, R, k, before, one)
  given = {};
  if (! isempty (job.given))
    given = {job.given(:,k)};
  endif
  [qs, ns, br, one.distance, info] = m.ikn (P, R, given{:});
  if (job.branch > numel (br))
    error ("%s: option branch: expected one of the %d branches of IKN (0: any), found %d", who, ...
           numel (br), job.branch);
  elseif (info == 1)
    one.status = "unreachable";
    return;
  elseif (info == 2)
    one.status = "singular";
  endif
  all_ = repmat (before, 1, ns);
  all_(job.rows,:) = qs(:,1:ns);
  if (! isempty (job.given))
    [~, places] = ismember (cellstr (m.json.reach.given), m.coordinates);
    all_(places,:) = repmat (job.given(:,k), 1, ns);
  endif
  one.solutions = all_;
  [q, i] = m.module ("choose", all_, before, job.turns, job.limits, br(1:ns), job.branch);
  if (i == 0)
    one.status = "limits";
    return;
  endif
  one.q = q;
  one.branch = br(i);
endfunction

## a speed that does not move the tool, where it is singular (host/reach/reach.h)
function one = with_free (m, job, one)
  n = m.sizes.nu;
  J = m.jpt (job.time, one.q, zeros (n, 1))(1:3+3*job.whole,n*(job.tool-1)+1:n*job.tool);
  if (m.sizes.nlam > 0)
    [~, ~, H] = m.con (job.time, one.q);
    J = [J; H];
  endif
  [singular, one.free] = m.module ("free", J, strcmp (one.status, "singular"));
  if (singular)
    one.status = "singular";
  endif
endfunction
