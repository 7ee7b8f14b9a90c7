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
## @var{n} rows of @var{nx} states instead of @var{x0}; with @var{x0} [] the first of them has to be
## a start that gsmbp_simulate takes
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
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x0", x0, "times", times);
  [own, rest] = read_options (who, varargin);
  rows = rows_of (who, m, own);
  if (isempty (x0) && ! isempty (rows.starts))
    x0 = rows.starts(1,:);
  endif
  p = gs.run.plan_many (who, m, x0, times, rest);
  gs.given.refuse_given_modes (who, m, rows.inputs, p.o.modes);
  e = gs.run.many_runs (who, p, rows);
  if (isfield (e, "sharp"))
    gs.events.sharp_friction (who, m, e.sharp, rows.n);
    e = rmfield (e, "sharp");
  endif
  e.of = @(name) gs.run.ensemble_values (who, m, e.x, e.v, e.y, name);
  e.final = permute (e.x(end,:,:), [3, 2, 1]);
  e.parameters = own.parameters;
endfunction

## its own options, and those of gsmbp_simulate
function [own, rest] = read_options (who, pairs)
  table = {"parameters", struct(), "any"
           "starts", [], "any"
           "inputs", [], "any"
           "threads", nproc(), "whole"
           "lanes", true, "flag"};
  [names, values] = gs.given.name_value_pairs (who, "option", pairs);
  known = gs.run.option_table ();
  k = find (! ismember (names, [table(:,1); known(:,1)]), 1);
  if (! isempty (k))
    error ("%s: unknown option %s", who, ...
           gs.text.nearest_word (names{k}, sort ([table(:,1); known(:,1)])'));
  endif
  mine = ismember (names, table(:,1));
  own = gs.given.call_options (who, table, [names(mine); values(mine)](:)');
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
            "parameter, found %s"], who, gs.text.shown_value (own.parameters));
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
    gs.given.check_parameter (who, m, name{1});
    values = own.parameters.(name{1})(:);
    finite (who, ["parameter " name{1}], values);
    rows.which(end+1,1) = find (strcmp (fieldnames (m.par), name{1}));
    rows.table(:,end+1) = double (values);
  endfor
  if (! isempty (names))
    rows.broken = gs.model.broken_rules (m, own.parameters);
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
  free = gs.model.free_inputs (m);
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
    error ("%s: %s: expected real numbers, found %s", who, what, gs.text.shown_value (x));
  endif
  k = find (any (! isfinite (x), 2), 1);
  if (! isempty (k))
    error ("%s: %s: expected finite numbers, found %s in row %d", who, what, ...
           gs.text.shown_value (x(k,:)), k);
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
