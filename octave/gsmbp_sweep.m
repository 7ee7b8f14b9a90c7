## -*- texinfo -*-
## @c category Runs
## @deftypefn {} {@var{w} =} gsmbp_sweep (@var{m}, @var{x0}, @var{times}, @
## @var{options}, @dots{})
## A sweep over parameters: a plan of samples, the runs, one table of what is kept of
## them, statistics.
##
## @var{m}, @var{x0}, @var{times}: as @code{gsmbp_simulate}; so are all options but these:
## @table @code
## @item "vary"
## a struct: for each parameter that varies [low, high], uniform; more numbers, a list of
## values, all as likely; or @{"normal", mean, standard deviation@} [SI]
## @item "plan"
## "sobol" (default): points that fill the space evenly; "latin": Latin hypercube;
## "random": Monte Carlo; "grid": all pairings of lists and of ends; "corners": all pairings of
## ends (of a normal distribution: three standard deviations); "indices": Sobol points
## in the arrangement of Saltelli, for the indices of Sobol, @code{n (k + 2)} runs
## @item "runs"
## how many samples @var{n}, default 256; those of a grid or of corners follow from "vary".
## "indices": 63 at the least, below which columns of the points go together; 255 give indices
## within some 0.04, 1023 within some 0.02 or, of what is nearly linear, 0.006
## @item "seed"
## of "latin" and "random", a whole number, default 1: the same seed, the same plan
## @item "keep"
## what is kept of a run: "final NAME", "peak NAME" (the largest modulus), "max NAME",
## "min NAME", "mean NAME", "rms NAME" of states, inputs and outputs, at the @var{times} that
## are asked for (mean and rms by the trapezoidal rule), "at T NAME" at the one of these that is T,
## "whole NAME" at all of them; of events "first NAME", "last NAME", when [s] (NaN where there was
## none), and "count NAME"; "state_margin1", the least value of the first margin of devices
## (@code{m.state_margins}: strokes, pressures) at these times; "phase_margin" [rad],
## "gain_margin", "delay_margin" [s], "Ms" of the control loop of option "loop"; default the last
## value of every output, or of every state where there are none.  None is given twice.  A run that
## an event of its scene ended stays in its last state: that is what final, at and whole have from
## there on, and mean and rms count it up to the last of the @var{times}; peak, max, min, events and
## margins are those of the motion
## @item "loop"
## a function of the model with the parameters of a run that gives a controller
## (@code{gsmbp_control}, @code{gsmbp_pid}): the margins are those of its loop (@code{gsmbp_loop}),
## the worst of its inputs, 1e6 where there is no bound; a run whose loop has none failed.  For the
## gains of one controller @var{c} on the machine of each run: a function that gives @var{c} with
## the field @code{plant} of a controller that is designed for that model
## @item "demand"
## a cell with a row for each demand: what is kept, lower limit, upper limit
## @item "threads"
## see @code{gsmbp_ensemble}
## @item "file"
## the table goes into this file in HDF5, and on the way there every finished chunk of runs into
## the folder @file{FILE.parts}, whole or not at all, so that a sweep that is killed loses the
## chunk under way alone
## @item "resume"
## true: goes on with what an interrupted sweep left there, reads a finished @file{FILE}, or begins
## where there is neither; the table is that of a sweep that was not interrupted, bit for bit.
## What is of another sweep is an error that says what differs
## @item "timeout"
## of the whole sweep [s]; 0, the default: none
## @item "chunk"
## how many runs a chunk has at most, default 16384; fewer where they take long
## @item "lanes"
## false: one run after the other; true, the default: side by side, where the scene was emitted with
## the request lanes and the runs can be (@pxref{Runs in lanes})
## @item "program"
## a folder: no runs, but a program for them is put there and built, in Fortran and C (and C++ for
## runs in lanes), without Octave, for MPI where that is installed:
## @code{mpirun -n 64 folder/sweep}; @code{@var{w}.program} is its file.  The folder is new, empty,
## or that of such a program without runs of another sweep.  The program writes @file{sweep.h5}
## there, by chunks as above: a start after an end of any kind goes on, and so does "file" of that
## name with "resume"
## @end table
##
## @var{w} has the fields
## @table @code
## @item names, units, values
## of the columns of the table, the parameters, then what is kept; a row for each run of the plan,
## NaN in what is kept where it failed or, after Ctrl-C or a timeout, was not made
## @item ok, reason, reached
## as of @code{gsmbp_ensemble}
## @item whole
## without "file": of the whole runs that are kept, a struct array of name, unit, values (a row for
## each run); with "file" they are there alone
## @item mean, std, min, max, quantiles
## of what is kept, over the runs that came to their end and have it (an event may never have been;
## then no demand of it is kept); quantiles at 0.05, 0.5, 0.95, a row each
## @item correlation
## of ranks (Spearman) of what is kept, a column each, with the parameters, a row each
## @item first, total
## plan "indices": the indices of Sobol, a row for each parameter, a column for what is
## kept: the share of the variance that a parameter makes alone, and with all others.  Samples of
## which a run has no number are left out, with a warning (@code{gsmbp:indices}); NaN where fewer
## than 32 are left
## @item corner
## plan "corners": a struct array, one for what is kept: name; largest and least of it; at_largest
## and at_least, the corners in words, as "la high, km low"; failed, those whose run did not come
## to its end
## @item yield
## the share of all runs that were made, came to their end and keep all demands
## @item stopped
## "interrupted" by Ctrl-C or "timeout", with what there is so far and a warning; the finished
## chunks of a "file" stay on disk for "resume"; else ""
## @item seconds
## of the runs alone
## @end table
##
## A sample is a function of the plan, the seed and its number; the table is the same for
## any number of threads, chunks and interruptions.
##
## The file has the data sets @code{/table} (a row for each run), @code{/names} and @code{/units} of
## its columns (which are attributes of it, too), @code{/ok}, @code{/reached}, @code{/failed/run}
## and @code{/failed/reason}, @code{/whole/NAME} and @code{/times}, @code{/description}.  Octave's
## @code{load ("-hdf5", file)} gives arrays of two dimensions transposed: @code{s.table'}.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> vary = struct ("la", [4e-3 6e-3], "km", @{@{"normal", 0.228, 0.005@}@});
## >> kept = @{["final " m.states@{4@}]@};
## >> o = @{"input", 12, "vary", vary, "runs", 64, "keep", kept@};
## >> w = gsmbp_sweep (m, m.initial, [0 0.1 0.2], o@{:@});
## >> size (w.values)
## ans =
##    64    3
## @end example
##
## A warning (@code{gsmbp:sign}) tells of lengths, masses, inertias that are above 0 in the
## model and below in samples; another (@code{gsmbp:failed}) that half of the runs or more failed,
## how many, and why the first did: statistics are of the others.
##
## Errors: as @code{gsmbp_ensemble}, before anything is on the disk; a distribution or a word that
## is none; more than 20 parameters in a plan of Sobol points, fewer than 63 samples for indices; a
## table of more than 1e9 numbers; both "file" and "program"; a file or a folder of others that is
## there already; a disk that is full.
## Source: Joe and Kuo, direction numbers (2008); Saltelli and others, variance based sensitivity
## analysis (2010), their estimates (b) and (f).
## @seealso{gsmbp_ensemble, gsmbp_simulate, gsmbp_design}
## @end deftypefn

function w = gsmbp_sweep (m, x0, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_sweep";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x0", x0, "times", times);
  [o, rest] = gs.sweep.sweep_options (who, m, varargin);
  names = fieldnames (o.vary)';
  cellfun (@(name) gs.given.check_parameter (who, m, name), names);
  times = gs.given.given_times (who, times);
  kept = gs.sweep.kept_results (who, m, o.keep, times);
  check_loop (who, m, o, kept);
  p = gs.run.plan_many (who, m, x0, times, rest);   # before anything is on the disk
  plain = kept(! [kept.whole]);
  rest_of = isempty (o.file) * nnz ([kept.whole]) * numel (times);   # of whole runs
  table = gs.sweep.plan_table (who, o, numel (plain) + rest_of);
  w = struct ("names", {[names, {plain.what}]}, "units", {[units_of(m, names), {plain.unit}]});
  check_demands (who, o.demand, w.names);
  told_of_signs (who, m, names, w.units, table);
  s = struct ("who", who, "m", m, "times", times, "plan", p, "names", {names}, "table", table, ...
              "kept", kept, "threads", o.threads, "lanes", o.lanes, ...
              "chunk", o.chunk, "timeout", o.timeout, "loop", o.loop);
  told = gs.sweep.describe_sweep (m, x0, times, rest, o, kept);
  records = gs.sweep.record_names (told, w.names, w.units, kept, table, times);
  if (! isempty (o.program))
    gs.events.sharp_friction (who, m, sharp_at_start (s), rows (table));
    w = struct ("program", gs.sweep.build_program (who, s, p, records, o.program));
    return;
  elseif (isempty (o.file))
    r = gs.sweep.run_blocks (who, s, []);
  else
    r = gs.sweep.read_results (who, s, gs.sweep.open_journal (who, m, o, told, records));
  endif
  w.stopped = said_if_stopped (who, m, o, r);
  told_of_margins (who, m, r.outside, rows (table));
  gs.events.sharp_friction (who, m, r.sharp, rows (table));
  w.values = [table, r.values];
  [w.ok, w.reached, w.reason, w.seconds] = deal (r.ok, r.reached, r.reason, r.seconds);
  [w, out] = gs.sweep.statistics_of (w, table, r.values, o);
  if (isempty (w.stopped))
    gs.run.most_failed (who, m, w.ok, w.reason);
    told_of_left_out (who, m, o.runs, {plain.what}, out);
  endif
  w.yield = yield (w, o.demand, r.made);
  if (strcmp (o.plan, "corners"))
    w.corner = gs.sweep.corner_values (w, table, r.values);
  endif
  if (isempty (o.file))
    w.whole = rmfield (kept([kept.whole]), {"what", "of", "whole", "way", "number", "time"});
    for k = 1:numel (w.whole)
      w.whole(k).values = r.whole{k};
    endfor
  endif
endfunction

function units = units_of (m, names)
  units = cell (size (names));
  for k = 1:numel (names)
    p = m.json.parameters(strcmp ({m.json.parameters.name}, names{k}));
    units{k} = p.unit;
  endfor
endfunction

## margins that are kept have a loop, which Octave calculates
function check_loop (who, m, o, kept)
  asked = {kept([kept.way] == 0).what};
  if (! (isempty (o.loop) || is_function_handle (o.loop)))
    error (["%s: option loop: expected a function of the model that gives a controller, found " ...
            "%s"], who, gs.text.shown_value (o.loop));
  elseif (isempty (asked) != isempty (o.loop))
    error (["%s: margins in option keep (%s) and option loop, a function of the model that " ...
            "gives a controller, belong together"], who, strjoin (asked, ", "));
  elseif (! isempty (asked) && ! isempty (o.program))
    error (["%s: option program: its runs have no margins: expected none in option keep, found " ...
            "%s"], who, strjoin (asked, ", "));
  elseif (! isempty (asked))
    check_law (who, m, o.loop);
  endif
endfunction

## what it gives for the model as it is
function check_law (who, m, loop)
  try
    law = loop (m);
  catch err
    error ("%s: option loop, at the parameters of the model: %s", who, err.message);
  end_try_catch
  if (! (isstruct (law) && isscalar (law) && isfield (law, "plant")))
    error (["%s: option loop: expected that it gives a controller of gsmbp_control or " ...
            "gsmbp_pid, found %s"], who, gs.text.shown_value (law));
  endif
endfunction

## a length, a mass or an inertia that the model has above 0 and samples have below
function told_of_signs (who, m, names, units, table)
  for k = 1:numel (names)
    below = nnz (table(:,k) < 0);
    if (below > 0 && any (strcmp (units{k}, {"m", "mm", "kg", "kg*m^2"})) && m.par.(names{k}) > 0)
      warning ("gsmbp:sign", ["%s: option vary: %s is %g %s in the model, and below 0 in %d of " ...
                              "%d samples"], who, names{k}, m.par.(names{k}), units{k}, below, ...
               rows (table));
    endif
  endfor
endfunction

function stopped = said_if_stopped (who, m, o, r)
  stopped = r.stopped;
  if (! isempty (stopped))
    how = {"; \"resume\", true goes on", ""}{1 + isempty(o.file)};
    warning ("gsmbp:stopped", "%s: %s: %s with %d of %d runs made%s", who, m.name, ...
             gs.run.stopped_text (stopped), nnz (r.made), numel (r.made), how);
  endif
endfunction

## runs, with a margin of a device that was passed in each
function told_of_margins (who, m, outside, n)
  if (! isempty (outside))
    [run, k] = deal (outside(1,1), outside(1,2));
    warning ("gsmbp:margin", ["%s: %s: devices were outside of their margins in %d of %d runs, " ...
                              "run %d first: %s: expected above 0; \"keep\", " ...
                              "\"state_margin%d\" tells how far"], who, m.name, ...
             rows (outside), n, run, m.state_margins{k}, k);
  endif
endfunction

## ports of runs that a program makes: which events there will be is not known
function list = sharp_at_start (s)
  list = struct ([]);
  [m, p] = deal (s.m, s.plan);
  if (isempty (m.events) || ! any (strcmp (p.method, {"radau", "cvode"})))
    return;
  endif
  all_ = gs.sweep.run_rows (s, 1:rows (s.table));
  for i = find (strcmp (all_.broken, ""))'
    run = struct ("run", i, "method", p.method, "atol", p.atol, "happened", ...
                  1:numel (m.events), "t", s.times(1), "x", p.given.x0, "v", m.input_starts);
    list = [list, gs.events.sharp_ports(gs.run.model_of_row (m, all_, i), run)];
  endfor
endfunction

## indices of Sobol without base samples of which a run has no number
function told_of_left_out (who, m, n, kept, out)
  [most, k] = max ([0, out]);
  if (most > 0)
    warning ("gsmbp:indices", ["%s: %s: the indices of %s are without %d of %d base samples, " ...
                               "of which a run has no number (with fewer than 32 there are " ...
                               "none)"], ...
             who, m.name, kept{k-1}, most, n);
  endif
endfunction

## rows of what is kept, lower and upper limit
function check_demands (who, demands, names)
  if (! (iscell (demands) && (isempty (demands) || columns (demands) == 3)))
    error (["%s: option demand: expected a cell with rows of what is kept, lower and upper " ...
            "limit, found %s"], who, gs.text.shown_value (demands));
  endif
  for row = demands'
    if (! (ischar (row{1}) && any (strcmp (names, row{1}))))
      error ("%s: option demand: unknown %s", who, gs.text.nearest_word (row{1}, names));
    elseif (! (isscalar (row{2}) && isscalar (row{3}) && isreal ([row{2:3}]) ...
               && row{2} <= row{3}))
      error (["%s: option demand: %s: expected a lower limit and an upper one that is not " ...
              "below it, found %s and %s"], who, row{1}, gs.text.shown_value (row{2}), ...
             gs.text.shown_value (row{3}));
    endif
  endfor
endfunction

## the share of the runs that keep all demands
function share = yield (w, demands, made)
  keeps = w.ok;
  for row = demands'
    value = w.values(:,strcmp (w.names, row{1}));
    keeps &= value >= row{2} & value <= row{3};
  endfor
  share = mean (keeps(made));
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!test <a grid is made of its pairings>
%! w = gsmbp_sweep (m, [0.1 0 0], [0 0.1], "plan", "grid", "vary", ...
%!                  struct ("m", [1 1.2], "l", [0.4 0.5 0.6]));
%! assert (w.values(:,1:2), [1 .4; 1 .5; 1 .6; 1.2 .4; 1.2 .5; 1.2 .6]);
%! assert (w.names{3}, ["final " {m.outputs, m.states}{1 + isempty(m.outputs)}{1}]);
%!error <option plan> gsmbp_sweep (m, [0 0 0], [0 1], "vary", struct ("m", [1 2]), "plan", "all")
%!error <option vary is missing: expected a struct> gsmbp_sweep (m, [0 0 0], [0 1])
%!error <1e\+10 runs with 2 numbers each are 2e\+10 numbers; expected 1e9 at the most>
%! gsmbp_sweep (m, [0 0 0], [0 1], "vary", struct ("m", [1 2]), "runs", 1e10)
%!error <1e\+09 runs with 4 numbers each>
%! gsmbp_sweep (m, [0 0 0], [0 1], "vary", struct ("m", 1:1e5, "l", 1:1e4), "plan", "grid", ...
%!              "keep", {"final q", "peak q"})
%!error <options file and program: expected one of them>
%! gsmbp_sweep (m, [0 0 0], [0 1], "vary", struct ("m", [1 2]), "file", "a.h5", "program", "a")
%!test <what is on disk is what is in memory>
%! file = [tempname() ".h5"];
%! o = {"runs", 70, "vary", struct("m", [1 1.2]), "keep", {"rms q", "at 0.1 q"}, "chunk", 30};
%! w = gsmbp_sweep (m, [0.1 0 0], [0 0.1 0.2], o{:}, "file", file);
%! tidy = onCleanup (@() delete (file));
%! assert (w.values, gsmbp_sweep (m, [0.1 0 0], [0 0.1 0.2], o{:}).values);
%! s = load ("-hdf5", file);
%! assert (s.table', w.values);
%! assert (cellstr (s.names)', w.names);
%! fail ("gsmbp_sweep (m, [0.1 0 0], [0 0.1 0.2], o{:}, \"file\", file)", "there is a file");
