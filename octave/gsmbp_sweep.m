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
## how many samples @var{n}, default 256; those of a grid or of corners follow from "vary"
## @item "seed"
## of "latin" and "random", a whole number, default 1: the same seed, the same plan
## @item "keep"
## what is kept of a run: "final NAME", "peak NAME" (the largest modulus), "max NAME",
## "min NAME", "mean NAME", "rms NAME" of states, inputs and outputs, at the @var{times} that
## are asked for (mean and rms by the trapezoidal rule); default the last value of every
## output, or of every state where there are none
## @item "demand"
## a cell with a row for each demand: what is kept, lower limit, upper limit
## @item "threads"
## see @code{gsmbp_ensemble}
## @end table
##
## @var{w} has the fields
## @table @code
## @item names, units, values
## of the columns of the table, the parameters, then what is kept; a row for each run, NaN where
## it failed
## @item ok, reason
## as of @code{gsmbp_ensemble}
## @item mean, std, min, max, quantiles
## of what is kept, over the runs that came to their end; quantiles at 0.05, 0.5, 0.95, a row each
## @item correlation
## of ranks (Spearman) of what is kept, a column each, with the parameters, a row each
## @item first, total
## plan "indices": the indices of Sobol, a row for each parameter, a column for what is
## kept: the share of the variance that a parameter makes alone, and with all others
## @item yield
## the share of all runs that came to their end and keep all demands
## @item seconds
## of the runs alone
## @end table
##
## A sample is a function of the plan, the seed and its number; the table is the same for
## any number of threads.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> vary = struct ("la", [4e-3 6e-3], "km", @{@{"normal", 0.228, 0.005@}@});
## >> w = gsmbp_sweep (m, m.initial, [0 0.1 0.2], "input", 12, "vary", vary, "runs", 64, ...
##                     "keep", @{["final " m.states@{4@}]@});
## >> size (w.values)
## ans =
##    64    3
## @end example
##
## Errors: as @code{gsmbp_ensemble}; a distribution or a word that is none; more than 20
## parameters in a plan of Sobol points.
## Source: Joe and Kuo, direction numbers (2008); Saltelli and others, variance based sensitivity
## analysis (2010), their estimates (b) and (f).
## @seealso{gsmbp_ensemble, gsmbp_simulate, gsmbp_design}
## @end deftypefn

function w = gsmbp_sweep (m, x0, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_sweep";
  gsmbp__model (who, m);
  [o, rest] = read_options (who, m, varargin);
  names = fieldnames (o.vary)';
  cellfun (@(name) gsmbp__known_parameter (who, m, name), names);
  kept = gsmbp__kept (who, m, o.keep);
  table = gsmbp__sweep_plan (who, o);
  w = struct ("names", {[names, {kept.what}]}, "units", {[units_of(m, names), {kept.unit}]});
  [values, w.ok, w.reason, w.seconds] = runs (m, x0, times, rest, names, table, kept, o.threads);
  w.values = [table, values];
  w = statistics (w, table, values, o);
  w.yield = yield (who, w, o.demand);
endfunction

function [o, rest] = read_options (who, m, pairs)
  table = {"vary", struct(), "any"
           "plan", "sobol", {"sobol", "latin", "random", "grid", "corners", "indices"}
           "runs", 256, "whole"
           "seed", 1, "whole"
           "keep", {}, "names"
           "demand", {}, "any"
           "threads", nproc(), "whole"};
  [names, values] = gsmbp__pairs (who, "option", pairs);
  known = gsmbp__simulate_options (false)(:,1);
  k = find (! ismember (names, [table(:,1); known]), 1);
  if (! isempty (k))
    error ("%s: unknown option %s", who, gsmbp__unknown (names{k}, sort ([table(:,1); known])'));
  endif
  mine = ismember (names, table(:,1));
  o = gsmbp__options (who, table, [names(mine); values(mine)](:)');
  rest = [names(! mine); values(! mine)](:)';
  if (! (isstruct (o.vary) && isscalar (o.vary) && numfields (o.vary) > 0))
    error (["%s: option vary: expected a struct with a range, a list or a distribution for " ...
            "each parameter, found %s"], who, gsmbp__shown (o.vary));
  elseif (! (o.runs >= 1))
    error ("%s: option runs: expected a whole number above 0, found %g", who, o.runs);
  endif
endfunction

function units = units_of (m, names)
  units = cell (size (names));
  for k = 1:numel (names)
    p = m.json.parameters(strcmp ({m.json.parameters.name}, names{k}));
    units{k} = p.unit;
  endfor
endfunction

## what is kept of all runs, some at a time: the runs themselves need not fit into memory
function [values, ok, reason, seconds] = runs (m, x0, times, rest, names, table, kept, threads)
  n = rows (table);
  values = NaN (n, numel (kept));
  [ok, reason, seconds] = deal (false (n, 1), repmat ({""}, n, 1), 0);
  some = max (64, min (4096, floor (4e6 / (m.sizes.nx + 1) / numel (times))));
  for first = 1:some:n
    i = first:min (n, first + some - 1);
    e = gsmbp_ensemble (m, x0, times, rest{:}, "threads", threads, "parameters", ...
                        cell2struct (num2cell (table(i,:), 1), names, 2));
    for k = 1:numel (kept)
      values(i,k) = kept(k).of (e.t, e.of (kept(k).name));
    endfor
    values(i(! e.ok),:) = NaN;
    [ok(i), reason(i)] = deal (e.ok, e.reason);
    seconds += e.seconds;
  endfor
endfunction

function w = statistics (w, table, values, o)
  good = values(w.ok,:);
  if (rows (good) < 2)
    [w.mean, w.std, w.min, w.max] = deal (NaN (1, columns (values)));
    w.quantiles = NaN (3, columns (values));
  else
    [w.mean, w.std] = deal (mean (good, 1), std (good, 0, 1));
    [w.min, w.max] = deal (min (good, [], 1), max (good, [], 1));
    w.quantiles = quantile (good, [0.05, 0.5, 0.95], 1, 7);
  endif
  w.correlation = NaN (columns (table), columns (values));
  if (rows (good) > 2)
    w.correlation = spearman (table(w.ok,:), good);
  endif
  if (strcmp (o.plan, "indices"))
    [w.first, w.total] = gsmbp__sobol_indices (values, columns (table));
  endif
endfunction

## the share of the runs that keep all demands
function share = yield (who, w, demands)
  if (! (iscell (demands) && (isempty (demands) || columns (demands) == 3)))
    error (["%s: option demand: expected a cell with rows of what is kept, lower and upper " ...
            "limit"], who);
  endif
  keeps = w.ok;
  for k = 1:rows (demands)
    at = find (strcmp (w.names, demands{k,1}), 1);
    if (isempty (at))
      error ("%s: option demand: unknown %s", who, gsmbp__unknown (demands{k,1}, w.names));
    endif
    keeps &= w.values(:,at) >= demands{k,2} & w.values(:,at) <= demands{k,3};
  endfor
  share = mean (keeps);
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
