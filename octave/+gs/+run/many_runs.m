## e = gs.run.many_runs (who, p, rows)
## Runs by the plan P of one of them (gs.run.plan_many).  ROWS: n, how many; which (numbers of the
## parameters that differ), table (their values, a row for each run), starts and inputs (rows, []
## for none), broken (which rule the parameters of each break, "" for none), threads, lanes.  E: the
## result of gsmbp_ensemble but for of, final and parameters.

function e = many_runs (who, p, rows)
  m = p.m;
  e = struct ("t", p.times(:));
  [e.x, e.v, e.y, info, counted, margins, stats, seconds, lanes, events, said] = ...
      run_all (p, m, rows);
  [e, cut] = judged (e, p, rows, stats, info, said);
  for i = cut'   # here, where nobody else has them: they are not copied, which takes seconds
    bad = stats.outputs(i)+1:numel (e.t);
    [e.x(bad,:,i), e.v(bad,:,i), e.y(bad,:,i)] = deal (NaN);
  endfor
  if (! isempty (m.events))
    e.events = struct ("run", events(1,:)', "t", events(2,:)', "number", events(3,:)', "mode", ...
                       events(4,:)');
    e.counted = counted_of (numel (m.events), counted);
    warn_of_more (who, m, sum (e.counted.count, 2), accumarray (events(1,:)', 1, [rows.n, 1]));
    e.sharp = sharp_runs (e, p, rows, stats);
  endif
  if (! isempty (m.state_margins))
    e = with_margins (who, e, p, rows, margins');
  endif
  [e.calls, e.accepted, e.rejected] = deal (stats.calls', stats.accepted', stats.rejected');
  done = sprintf ("with %d of %d runs at their end", nnz (e.ok), rows.n);
  e.cut = info(1,:)' == 9 | info(1,:)' == 10;
  e.stopped = gs.run.stopped_word (who, m, max ([0, info(1,e.cut)]), done, true);
  if (! any (e.cut))
    gs.run.most_failed (who, m, e.ok, e.reason);
  endif
  [e.threads, e.lanes, e.seconds] = deal (rows.threads, lanes, seconds);
endfunction

## all that the module has found; REASON: why each failed, "" where it did not
function [x, v, y, info, counted, margins, stats, seconds, lanes, events, reason] = ...
      run_all (p, m, rows)
  broken = {rows.broken, {}}{1 + all(strcmp (rows.broken, ""))};
  [x, v, y, counts, values, info, seconds, lanes, events, counted, reason, margins] = ...
      m.module ("ensemble", m.cst, p.given, rows.n, rows.which, rows.table, rows.starts, ...
                rows.inputs, broken, rows.threads, rows.lanes);
  stats = m.module ("statistics", counts, values);
endfunction

## columns for the N event functions from rows of counts and times
function c = counted_of (n, counted)
  part = @(k) counted(k*n+(1:n),:)';
  c = struct ("count", part (0), "first", part (1), "last", part (2));
  none = c.count == 0;
  [c.first(none), c.last(none)] = deal (NaN);
endfunction

## margins of devices: their least values, which of them were passed, and a warning where some were
function e = with_margins (who, e, p, rows, found)
  n = numel (p.m.state_margins);
  [outside, least] = deal (found(:,1:n) != 0, found(:,n+1:end));
  least(! isfinite (e.x(1,1,:))(:) | isinf (least)) = NaN;
  [e.margins, e.outside] = deal (least, outside);
  bad = any (outside, 2);
  k = find (bad, 1);
  if (isempty (k))
    return;
  endif
  m = gs.run.model_of_row (p.m, rows, k);
  here = all (isfinite (e.x(:,:,k)), 2);
  list = gs.start.range_margins (m, e.t(here), e.x(here,:,k), e.v(here,:,k));
  if (! isempty (list))
    warning ("gsmbp:margin", ["%s: %s: devices were outside of their margins in %d of %d runs; " ...
                              "run %d, at t = %.6g s first: %s"], who, m.name, nnz (bad), ...
             rows.n, k, list(1).time, list(1).said);
  endif
endfunction

## runs that had more events than are listed
function warn_of_more (who, m, count, listed)
  more = count > listed;
  if (any (more))
    [most, k] = max (count .* more);
    warning ("gsmbp:events", ["%s: %s: %d of %d runs had more events than are listed of a run " ...
                              "(run %d has %d, the first %d of them are): take shorter runs to " ...
                              "have all; those of e.counted are of all"], who, m.name, ...
             nnz (more), numel (more), k, most, listed(k));
  endif
endfunction

## ports whose friction falls too steeply for the method of their run (gs.events.sharp_ports)
function list = sharp_runs (e, p, rows, stats)
  list = struct ([]);
  for i = find (any (e.counted.count, 2) & stats.outputs' > 0)'
    k = stats.outputs(i);
    run = struct ("run", i, "method", p.method, "atol", p.atol, "happened", ...
                  find (e.counted.count(i,:)), "t", e.t(k), "x", e.x(k,:,i), "v", e.v(k,:,i));
    if (strcmp (p.method, "auto"))
      run.method = {"dp853", "radau"}{1 + stats.stiff(i)};
    endif
    if (any (strcmp (run.method, {"radau", "cvode"})))
      list = [list, gs.events.sharp_ports(gs.run.model_of_row (p.m, rows, i), run)];
    endif
  endfor
endfunction

## which runs came to their end; CUT: those whose rows behind the last one are to be NaN: a state
## where a run ended is none at a time asked for
function [e, cut] = judged (e, p, rows, stats, info, said)
  ended = info(1,:)' == 11;   # by an event of the user
  e.ok = strcmp (said, "");
  e.reached = stats.reached';
  e.reached(e.ok & ! ended) = e.t(end);
  e.reason = said;
  idle = stats.calls' == 0 & any (info(1,:)' == [0, 9, 10], 2);   # not begun, perhaps many
  cut = find (! (e.ok | idle));
  for i = cut'
    own = structfun (@(row) row(i), stats, "UniformOutput", false);
    e.reason{i} = reason (p, rows, i, info(1,i), own, said{i}, last_of (e, i, own.outputs + 1));
  endfor
endfunction

## why run I failed, as gsmbp_simulate says it of the model with its parameters; SAID by the engine
function text = reason (p, rows, i, info, stats, said, last)
  if (info == 3 && stats.failed == 9)   # GS_BEFORE_START of gsmbp/failures.h
    [~, remedy] = gs.start.verdict_words (stats.failed_info);
    text = [said remedy];
  else
    text = gs.run.failure_text (gs.run.model_of_row (p.m, rows, i), said, info, stats, last);
  endif
endfunction

function last = last_of (e, i, k)
  last = [];
  if (k <= rows (e.x) && all (abs ([e.x(k,:,i), e.v(k,:,i)]) <= 1e300))
    last = struct ("x", e.x(k,:,i)', "v", e.v(k,:,i)');
  endif
endfunction
