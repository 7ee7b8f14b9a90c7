## e = gs.run.many_runs (who, p, rows)
## Runs by the plan P of one of them (gs.run.plan_many).  ROWS: n, how many; which (numbers of the
## parameters that differ), table (their values, a row for each run), starts and inputs (rows, []
## for none), broken (which rule the parameters of each break, "" for none), threads, lanes.  E: the
## result of gsmbp_ensemble but for of, final and parameters.

function e = many_runs (who, p, rows)
  m = p.m;
  good = strcmp (rows.broken, "");
  e = struct ("t", p.times(:));
  [e.x, e.v, e.y, info, counted, margins, stats, seconds, lanes, events, said] = ...
      run_all (p, m, rows, good);
  [e, cut] = judged (e, p, rows, ! good, stats, info, said);
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

## the runs whose parameters break no rule of the scene, GOOD; NaN and zeros for the others
function [x, v, y, info, counted, margins, stats, seconds, lanes, events, said] = ...
      run_all (p, m, rows, good)
  n = {[numel(p.times), m.sizes.nx], [numel(p.times), m.sizes.nv], ...
       [numel(p.times), m.sizes.ny], 20, 20, 2, 3 * numel(m.events), 2 * numel(m.state_margins)};
  [parts, text] = deal (cellfun (@(k) zeros ([k, 0]), n, "UniformOutput", false), {});
  [seconds, lanes, events] = deal (0, false, zeros (4, 0));
  if (any (good))
    of = {@(x) x(good(1:size (x, 1)),:), @(x) x}{1 + all(good)};
    [parts{1:6}, seconds, lanes, events, parts{7}, text, parts{8}] = ...
        m.module ("ensemble", m.cst, p.given, nnz (good), rows.which, of (rows.table), ...
                  of (rows.starts), of (rows.inputs), rows.threads, rows.lanes);
  endif
  if (! all (good))
    for i = 1:8
      parts{i} = among (parts{i}, n{i}, good, {NaN, 0}{1 + (i > 3)});
    endfor
    events(1,:) = find (good)(events(1,:))(:)';
  endif
  said = repmat ({""}, rows.n, 1);
  if (! isempty (text))
    said(good) = text;
  endif
  [x, v, y, counts, values, info, counted, margins] = parts{:};
  stats = p.m.module ("statistics", counts, values);
endfunction

## SOME, of size K for each of the good ones of all runs, and NONE for the others
function all_ = among (some, k, good, none)
  all_ = repmat (none, [prod(k), numel(good)]);
  all_(:,good) = reshape (some, prod (k), []);
  all_ = reshape (all_, [k, numel(good)]);
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

## which runs came to their end; BROKEN: those whose parameters break a rule; CUT: those whose rows
## behind the last one are to be NaN: a state where a run ended is none at a time asked for
function [e, cut] = judged (e, p, rows, broken, stats, info, said)
  ended = info(1,:)' == 11;   # by an event of the user
  e.ok = (info(1,:)' == 0 | ended) & info(2,:)' == 0 & ! broken;
  e.reached = stats.reached';
  e.reached(e.ok & ! ended) = e.t(end);
  e.reason = rows.broken;
  e.reached(broken) = e.t(1);
  idle = ! broken & stats.calls' == 0 & any (info(1,:)' == [9, 10], 2);   # not begun, perhaps many
  e.reason(idle & info(1,:)' == 9) = {"not begun: interrupted by Ctrl-C"};
  e.reason(idle & info(1,:)' == 10) = {"not begun: ended by option timeout"};
  failed = find (! e.ok)';
  for i = failed(cellfun ("isempty", e.reason(failed)))
    own = structfun (@(row) row(i), stats, "UniformOutput", false);
    e.reason{i} = reason (p, rows, i, info(:,i), own, said{i}, last_of (e, i, own.outputs + 1));
  endfor
  cut = find (! e.ok & ! idle);
endfunction

## why run I failed, as gsmbp_simulate says it of the model with its parameters
function text = reason (p, rows, i, info, stats, said, last)
  if (info(2) != 0)
    text = ["its parameters cannot be: " p.m.module("meaning", "pre", info(2))];
    return;
  endif
  m = gs.run.model_of_row (p.m, rows, i);
  if (info(1) == 3 && stats.failed == 7 && stats.failed_info == 13 && ! isempty (last))
    text = gs.events.wrong_mode (m, p.times(1), last.x, p.o.modes, stats.cause);
  else
    text = m.module ("failure", info(1), stats, said);
    if (! isempty (last) && stats.failed != 8)
      text = [text, gs.start.outside_range(m, stats.reached, last.x, last.v)];
    endif
    text = gs.run.failure_text (m, text, info(1), stats, last);
    if (info(1) == 3 && stats.failed == 9)   # GS_BEFORE_START of gsmbp/failures.h
      [~, remedy] = gs.start.verdict_words (stats.failed_info);
      text = [text remedy];
    endif
  endif
endfunction

function last = last_of (e, i, k)
  last = [];
  if (k <= rows (e.x) && all (abs ([e.x(k,:,i), e.v(k,:,i)]) <= 1e300))
    last = struct ("x", e.x(k,:,i)', "v", e.v(k,:,i)');
  endif
endfunction
