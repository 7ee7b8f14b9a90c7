## -*- texinfo -*-
## @c category Runs
## @deftypefn {} {@var{e} =} gsmbp_ensemble (@var{m}, @var{x0}, @var{times}, @
## @var{options}, @dots{})
## Many runs of a scene, compiled and on all cores: parameters, starts and inputs that
## differ from run to run.
##
## @var{m}, @var{x0} and @var{times} are those of @code{gsmbp_simulate}; what no option
## below says is the same in all runs.
## @table @code
## @item "parameters"
## a struct: a field of @var{n} values [SI], a vector, for each parameter that differs
## @item "starts"
## @var{n} rows of @var{nx} states instead of @var{x0}
## @item "inputs"
## @var{n} rows of constant inputs instead of "input", a column for each as there
## @item "threads"
## how many runs go on at a time, default all cores
## @item "lanes"
## whether sixteen runs of a thread go on side by side in vectors, if the scene was emitted with the
## request @code{lanes}, the method is "dp853", "rk4" or "auto", the precision double; default true
## @end table
## All other options go to @code{gsmbp_simulate}, but "sensitivity", "audit", "samples" and
## inputs by a function of Octave.
##
## A run depends on its own row alone: the same numbers come back, bit by bit, from
## whatever number of threads, in whatever order, and from @code{gsmbp_set} and
## @code{gsmbp_simulate} (where the tolerances are given: their defaults follow the sizes
## of @var{m}).  In lanes they are the same in whatever lane, but beside
## @code{gsmbp_simulate} as rounding has it.  One that fails ends alone.  With loops every
## start is moved onto the constraints of its run; a run whose start @code{gsmbp_simulate}
## refuses is one that failed.
##
## @var{e} has the fields
## @table @code
## @item t, x, v, y
## times, states, inputs, outputs: a row for each time, a page for each run; NaN where
## a run did not come to
## @item of
## a function: @code{e.of ("motor.i")} has a row for each time and a column for each run, of
## a state, an input or an output
## @item final
## the states at the last time, a row for each run
## @item events
## in scenes that have events, a struct with a row for each of all runs, run by run: @code{run},
## @code{t} [s], @code{number} (of @code{m.events}), @code{mode} (after it); of a run the first
## 10000 of them, and a warning (@code{gsmbp:events}) where one had more
## @item counted
## in scenes that have events, a struct with a row for each run and a column for each of
## @code{m.events}: @code{count}, how many there were, @code{first} and @code{last} [s], when the
## first and the last one was (NaN: there was none); of all events, those that are not listed, too
## @item margins, outside
## in scenes whose devices have margins (@code{m.state_margins}: strokes, pressures), a row for each
## run and a column for each of them: its least value at @var{times}, as far as the run came, and
## whether it was passed there, as @code{stats.margins} of @code{gsmbp_simulate} says it; a warning
## (@code{gsmbp:margin}) tells how many runs did so
## @item ok, reason, reached
## for each run: whether it came to its end, if not why, and the time that it
## reached [s]; one that an event of its scene has ended is at its end, and its state stays there
## Where half or more failed a warning (@code{gsmbp:failed}) says how many and why the first did
## @item calls, accepted, rejected
## for each run: calls of the right-hand side, steps
## @item parameters
## as given
## @item threads, seconds
## of the runs alone
## @item lanes
## whether they were in lanes
## @item stopped
## "interrupted" by Ctrl-C or "timeout" (that of all runs together), with what there is so far
## and a warning (@code{gsmbp:stopped}); else ""
## @item cut
## for each run: whether that ended it, or did not let it begin
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> table = struct ("la", linspace (2e-3, 5e-3, 50));
## >> e = gsmbp_ensemble (m, m.initial, [0, 0.1, 0.2], "input", 12, "parameters", table);
## >> size (e.x), all (e.ok)
## ans =
##     3    7   50
## ans = 1
## @end example
##
## Errors: as @code{gsmbp_simulate}; a parameter that the scene has not; columns of other
## lengths; numbers that are not finite.
## Source: own.
## @seealso{gsmbp_simulate, gsmbp_set}
## @end deftypefn

function e = gsmbp_ensemble (m, x0, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_ensemble";
  gsmbp__model (who, m);
  [own, rest] = read_options (who, varargin);
  rows = rows_of (who, m, own);
  if (isempty (x0) && ! isempty (rows.starts))
    x0 = rows.starts(1,:);
  endif
  p = gsmbp__run_of_many (who, m, x0, times, rest);
  [x, v, y, counts, values, info, counted, margins, seconds, lanes, events, said] = ...
      run_all (p, m, rows);
  e = struct ("t", p.times(:), "x", x, "v", v, "y", y);
  e = judged (e, p, rows, counts, values, info, said);
  e.of = @(name) gsmbp__of_ensemble (who, m, e.x, e.v, e.y, name);
  e.final = permute (e.x(end,:,:), [3, 2, 1]);
  if (! isempty (m.events))
    e.events = struct ("run", events(1,:)', "t", events(2,:)', "number", events(3,:)', "mode", ...
                       events(4,:)');
    e.counted = counted_of (numel (m.events), counted);
    warn_of_more (who, m, sum (e.counted.count, 2), accumarray (events(1,:)', 1, [rows.n, 1]));
  endif
  if (! isempty (m.state_margins))
    e = with_margins (who, e, p, rows, margins');
  endif
  [e.calls, e.accepted, e.rejected] = deal (counts(1,:)', counts(2,:)', counts(3,:)');
  e.parameters = own.parameters;
  done = sprintf ("with %d of %d runs at their end", nnz (e.ok), rows.n);
  e.cut = info(1,:)' == 9 | info(1,:)' == 10;
  e.stopped = gsmbp__stopped (who, m, max ([0, info(1,e.cut)]), done, true);
  if (! any (e.cut))
    gsmbp__most_failed (who, m, e.ok, e.reason);
  endif
  [e.threads, e.lanes, e.seconds] = deal (rows.threads, lanes, seconds);
endfunction

## the runs whose parameters break no rule of the scene; NaN and zeros for the others
function [x, v, y, counts, values, info, counted, margins, seconds, lanes, events, said] = ...
      run_all (p, m, rows)
  good = strcmp (rows.broken, "");
  n = {[numel(p.times), m.sizes.nx], [numel(p.times), m.sizes.nv], ...
       [numel(p.times), m.sizes.ny], 20, 20, 2, 3 * numel(m.events), 2 * numel(m.state_margins)};
  [parts, text] = deal (cellfun (@(k) zeros ([k, 0]), n, "UniformOutput", false), {});
  [seconds, lanes, events] = deal (0, false, zeros (4, 0));
  if (any (good))
    of = @(x) x(good(1:size (x, 1)),:);
    [parts{1:6}, seconds, lanes, events, parts{7}, text, parts{8}] = ...
        p.m.module ("ensemble", p.arguments{:}, nnz (good), rows.which, ...
                    cellfun (@double, struct2cell (p.m.par)), of (rows.table), of (rows.starts), ...
                    of (rows.inputs), m.nominal, strcmp (p.o.start, "check"), rows.threads, ...
                    rows.lanes);
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
  m = of_row (p.m, rows, k);
  here = all (isfinite (e.x(:,:,k)), 2);
  list = gsmbp__margins (m, e.t(here), e.x(here,:,k), e.v(here,:,k));
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

## its own options, and those of gsmbp_simulate
function [own, rest] = read_options (who, pairs)
  table = {"parameters", struct(), "any"
           "starts", [], "any"
           "inputs", [], "any"
           "threads", nproc(), "whole"
           "lanes", true, "flag"};
  [names, values] = gsmbp__pairs (who, "option", pairs);
  known = gsmbp__simulate_options (false);
  k = find (! ismember (names, [table(:,1); known(:,1)]), 1);
  if (! isempty (k))
    error ("%s: unknown option %s", who, ...
           gsmbp__unknown (names{k}, sort ([table(:,1); known(:,1)])'));
  endif
  mine = ismember (names, table(:,1));
  own = gsmbp__options (who, table, [names(mine); values(mine)](:)');
  rest = [names(! mine); values(! mine)](:)';
  given = rest(2 * find (ismember (rest(1:2:end), {"input", "motion"})));
  if (! isempty (own.inputs) && ! all (cellfun (@isempty, given)))
    error ("%s: give \"input\" or \"inputs\", not both", who);
  endif
endfunction

## what differs from run to run
function rows = rows_of (who, m, own)
  if (! (isstruct (own.parameters) && isscalar (own.parameters)))
    error (["%s: option parameters: expected a struct with a field of values for each " ...
            "parameter, found %s"], who, gsmbp__shown (own.parameters));
  endif
  if (! (own.threads >= 1))
    error ("%s: option threads: expected a whole number above 0, found %g", who, own.threads);
  endif
  names = fieldnames (own.parameters)';
  cellfun (@(name) no_matrix (who, ["parameter " name], own.parameters.(name)), names);
  given = ! [isempty(own.starts), isempty(own.inputs)];
  lengths = [cellfun(@(name) numel (own.parameters.(name)), names), ...
             [size(own.starts, 1), size(own.inputs, 1)](given)];
  what = [cellfun(@(name) ["parameter " name], names, "UniformOutput", false), ...
          {"option starts", "option inputs"}(given)];
  k = find (lengths != [lengths, 1](1), 1);
  if (isempty (lengths) || ! isempty (k) || lengths(1) == 0)
    differ (who, what, lengths, k);
  endif
  rows = struct ("n", lengths(1), "which", zeros (0, 1), "table", [], "starts", ...
                 width (who, "starts", own.starts, m.sizes.nx), "inputs", ...
                 all_inputs (who, m, own.inputs), "threads", own.threads, ...
                 "lanes", own.lanes, ...
                 "broken", {repmat({""}, lengths(1), 1)});
  for name = names
    gsmbp__known_parameter (who, m, name{1});
    values = own.parameters.(name{1})(:);
    finite (who, ["parameter " name{1}], values);
    rows.which(end+1,1) = find (strcmp (fieldnames (m.par), name{1}));
    rows.table(:,end+1) = double (values);
  endfor
  if (! isempty (names))
    rows.broken = gsmbp__broken_rules (m, own.parameters);
  endif
endfunction

## a list of values for the runs
function no_matrix (who, what, x)
  if (! (isempty (x) || isvector (x)))
    error ("%s: %s: expected a vector, found a %s matrix", who, what, ...
           sprintf ("%dx", size (x))(1:end-1));
  endif
endfunction

function differ (who, what, lengths, k)
  if (isempty (lengths))
    error (["%s: expected what differs from run to run, option \"parameters\", \"starts\" or " ...
            "\"inputs\""], who);
  elseif (lengths(1) == 0)
    error ("%s: %s: expected one value or more, found none", who, what{1});
  endif
  error ("%s: %s: expected %d values, one for each run as %s, found %d", who, what{k}, ...
         lengths(1), what{1}, lengths(k));
endfunction

## those of all inputs; in the columns of modes and of what sampled devices hold what the runs begin
## with, as gsmbp_simulate has it
function v = all_inputs (who, m, given)
  free = gsmbp__free_inputs (m);
  if (columns (given) == m.sizes.nv)
    free = 1:m.sizes.nv;
  endif
  width (who, "inputs", given, numel (free));
  v = repmat (m.input_starts(:)', rows (given), 1);
  v(:,free) = given;
endfunction

function x = width (who, name, x, n)
  if (! isempty (x) && (columns (x) != n || ndims (x) > 2))
    error ("%s: option %s: expected rows of %d numbers, found %s", who, name, n, ...
           sprintf ("%dx", size (x)(2:end))(1:end-1));
  endif
  finite (who, ["option " name], x);
endfunction

function finite (who, what, x)
  if (! (isnumeric (x) && isreal (x)))
    error ("%s: %s: expected real numbers, found %s", who, what, gsmbp__shown (x));
  endif
  k = find (any (! isfinite (x), 2), 1);
  if (! isempty (k))
    error ("%s: %s: expected finite numbers, found %s in row %d", who, what, ...
           gsmbp__shown (x(k,:)), k);
  endif
endfunction

## which runs came to their end
function e = judged (e, p, rows, counts, values, info, said)
  broken = ! strcmp (rows.broken, "");
  ended = info(1,:)' == 11;   # by an event of the user
  e.ok = (info(1,:)' == 0 | ended) & info(2,:)' == 0 & ! broken;
  e.reached = values(8,:)';
  e.reached(e.ok & ! ended) = e.t(end);
  e.reason = rows.broken;
  e.reached(broken) = e.t(1);
  idle = ! broken & counts(1,:)' == 0;   # those that were not begun, at a time many
  e.reason(idle & info(1,:)' == 9) = {"not begun: interrupted by Ctrl-C"};
  e.reason(idle & info(1,:)' == 10) = {"not begun: ended by option timeout"};
  for i = find (! e.ok & strcmp (e.reason, ""))'
    e.reason{i} = reason (p, rows, i, info(:,i), counts(:,i), values(:,i), said{i}, ...
                          last_of (e, i, counts));
  endfor
  for i = find (! e.ok)'   # a state where a run ended is none at a time that was asked for
    bad = counts(5,i)+1:numel (e.t);
    [e.x(bad,:,i), e.v(bad,:,i), e.y(bad,:,i)] = deal (NaN);
  endfor
endfunction

## the model with the parameters of run I, as far as a reason needs it: many runs may fail
function m = of_row (m, rows, i)
  if (isempty (rows.table))
    return;
  endif
  names = fieldnames (m.par)(rows.which);
  for k = 1:numel (names)
    m.par.(names{k}) = rows.table(i,k);
  endfor
  m = gsmbp__handles (m, {"rhs", "con", "prj", "mar", "hld"});
endfunction

## why run I failed, as gsmbp_simulate says it of the model with its parameters
function text = reason (p, rows, i, info, counts, values, said, last)
  if (info(2) != 0)
    text = ["its parameters cannot be: " p.m.module("meaning", "pre", info(2))];
    return;
  endif
  m = of_row (p.m, rows, i);
  if (info(1) == 3 && counts(7) == 9)
    text = off_constraints (m, p, rows, i);
  elseif (info(1) == 3 && counts(7) == 7 && counts(6) == 13 && ! isempty (last))
    text = gsmbp__wrong_mode (m, p.times(1), last.x, p.o.modes, counts(19));
  else
    text = gsmbp__failure (m, info(1), counts, values, said, last);
  endif
endfunction

## a start that is not taken (glue/start.h)
function text = off_constraints (m, p, rows, i)
  x = p.x0;
  if (! isempty (rows.starts))
    x = rows.starts(i,:);
  endif
  text = sprintf ("expected a state on the constraints at t = %.9g s", p.times(1));
  try
    gsmbp__start ("gsmbp_ensemble", m, p.times(1), x, p.o.start);
  catch err
    text = regexprep (err.message, "^gsmbp_ensemble: [^:]*: ", "");
  end_try_catch
endfunction

function last = last_of (e, i, counts)
  k = counts(5,i) + 1;
  last = [];
  if (k <= rows (e.x) && all (abs ([e.x(k,:,i), e.v(k,:,i)]) <= 1e300))
    last = struct ("x", e.x(k,:,i)', "v", e.v(k,:,i)');
  endif
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!test <each run is that of gsmbp_set and gsmbp_simulate>
%! e = gsmbp_ensemble (m, [0.1 0 0], [0 0.2], "parameters", struct ("m", [1 1.2]), "atol", 1e-9);
%! r = gsmbp_simulate (gsmbp_set (m, "m", 1.2), [0.1 0 0], [0 0.2], "atol", 1e-9);
%! assert (e.x(:,:,2), r.x);
%! assert (e.of ("drive.i")(2,:), e.final(:,3)');
%!error <unknown parameter "mm"> gsmbp_ensemble (m, [0 0 0], [0 1], "parameters", struct ("mm", 1))
