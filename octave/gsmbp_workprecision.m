## -*- texinfo -*-
## @c category Speed and accuracy
## @deftypefn  {} {@var{w} =} gsmbp_workprecision (@var{m}, @var{x0}, @var{times}, @
## @var{options}, @dots{})
## @deftypefnx {} {[@var{w}, @var{best}] =} gsmbp_workprecision (@dots{})
## Speed against error: what a simulation costs and how far it is from the
## truth, for several methods, steps and tolerances.
##
## The truth is the same Fortran built in quad precision, integrated by
## Dormand-Prince 8(5,3) at a tolerance of 1e-18 (option "reference"), from the same
## @var{x0} over the same @var{times}.  The error is the largest deviation of
## any coordinate (and, apart, of any state) at any of the @var{times}; in a scene without
## coordinates it is that of any state.  Time is the shortest of several runs, divided by the
## simulated time.
##
## Options: "rk4" (steps [s], default 10.^-(2:0.5:4)), "gauss" (steps, default none), "dp853"
## (tolerances, default 10.^-(4:2:14)), "cvode", "radau" and "index2", which is radau with
## "loops", "index2", for scenes with loops (tolerances, default none; where none of these six is
## given radau's are 10.^-(4:2:12), but of a build in quad);
## "print" (default true) writes the table; "file": a
## file for the figure, .png, .pdf, .svg or .eps (its numbers go into the .csv beside it);
## "seconds": how long each timing may take (default 0.1).  Any other option goes to
## @code{gsmbp_simulate} (input, motion, projection, @dots{}).
##
## @var{w} is a struct array with the fields @code{method}, @code{step} (or
## tolerance), @code{calls} of the right-hand side, @code{seconds} for each
## simulated second, @code{error} (coordinates, or states where there are none),
## @code{error_states};
## @code{w(1).reference} holds the rows of the truth.  @var{best}, a struct array, names for each
## power of ten of the error that was reached the fastest measurement that keeps to it:
## @code{below} (that power), @code{method}, @code{step}, @code{seconds}, @code{error}; the printed
## table ends with it.  An error beyond the largest number of the truth (rk4 in steps that are not
## stable, say) is an error of everything: such a measurement is the best of none, and not drawn.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> ways = @{"rk4", 1e-3, "dp853", [1e-6 1e-9], "seconds", 0.01, "print", false@};
## >> [w, best] = gsmbp_workprecision (m, m.initial, [0 0.1], "input", 12, ways@{:@});
## >> numel (w), max ([w.error]) < 1e-6
## ans = 3
## ans = 1
## >> isempty (best), best(1).below >= best(1).error
## ans = 0
## ans = 1
## @end example
##
## What runs warn of (@code{gsmbp:stiff}, @dots{}) is said once.
##
## Errors: as @code{gsmbp_simulate}; an option that is measured itself or unknown; no step and no
## tolerance, or such as cannot be; "index2" in a scene without loops; another ending of "file" than
## .png, .pdf, .svg, .eps: all before anything is measured; a reference that fails or does not come
## to its end.  The error of a run that does not is Inf.
## Source: own; Hairer's work-precision diagram.
## @seealso{gsmbp_simulate}
## @end deftypefn

function [w, best] = gsmbp_workprecision (m, x0, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_workprecision", m);
  gs.given.refuse_words ("gsmbp_workprecision", "x0", x0, "times", times);
  [o, rest] = read_options (m, varargin);
  check_runs (m, x0, times, o, rest);
  truth = reference (m, x0, times, o, rest);
  span = times(end) - times(1);
  [w, stats] = deal (struct ([]), {});
  for method = ways ()
    for step = o.(method{1})(:)'   # or tolerance
      [w, stats{end+1}] = measure (w, m, x0, times, o, rest, truth, method{1}, step, span);
    endfor
  endfor
  tell_once (m, stats);
  w(1).reference = truth.x;
  useful = w([w.error] <= largest (m, truth));
  best = best_of (useful);
  if (o.print)
    show (m, w, best, span, times(1));
  endif
  if (! isempty (o.file))
    figure_of (o.file, m, {useful, w}{1 + isempty(useful)});
  endif
endfunction

function list = ways ()
  rows = gs.text.table_rows ("GS_METHODS");
  rows = rows(! strcmp (rows(:,4), "both"),:);
  fixed = strcmp (rows(:,3), "fixed");
  list = [rows(fixed,1)', rows(! fixed,1)', {"index2"}];
endfunction

## are its steps of one length?
function yes = is_fixed (method)
  yes = false;
  if (! strcmp (method, "index2"))
    row = gs.run.method_row (method);
    yes = row.fixed;
  endif
endfunction

## its own options, and those for gsmbp_simulate
function [o, rest] = read_options (m, pairs)
  who = "gsmbp_workprecision";
  radau = strcmp (m.precision, "double");   # quad has none
  table = [ways()', repmat({[], "list"}, numel (ways ()), 1)];
  table{strcmp (table(:,1), "rk4"),2} = 10 .^ -(2:0.5:4);
  table{strcmp (table(:,1), "dp853"),2} = 10 .^ -(4:2:14);
  measures = ['"' strjoin(table(:,1)', '", "') '"'];
  many = rows (table);
  table = [table
           {"print", true, "flag"
           "file", "", "text"
           "seconds", 0.1, "nonnegative"
           "reference", 1e-18, "tolerance"}];
  [names, values] = gs.given.name_value_pairs (who, "option", pairs);
  measured = intersect (names, {"method", "step", "rtol", "atol", "drift"});
  if (! isempty (measured))
    error (["%s: option \"%s\" is what is measured: expected the steps or tolerances in " ...
            "%s"], who, measured{1}, measures);
  endif
  own = ismember (names, table(:,1));
  run = gs.run.option_table ();
  known = sort ([table(:,1); run(:,1)])';
  k = find (! ismember (names, known), 1);
  if (! isempty (k))
    error ("%s: unknown option %s", who, gs.text.nearest_word (names{k}, known));
  endif
  o = gs.given.call_options (who, table, [names(own); values(own)](:)');
  if (radau && ! any (ismember (table(1:many,1), names)))
    o.radau = 10 .^ -(4:2:12);
  endif
  if (all (cellfun (@(name) isempty (o.(name)), table(1:many,1))))
    error (["%s: nothing to measure: expected steps or tolerances in one of the options " ...
            "%s, found none"], who, measures);
  endif
  check_own (who, m, o);
  rest = [names(! own); values(! own)](:)';
endfunction

## steps above 0, tolerances above 0 and below 1, loops for index 2, a figure that can be
function check_own (who, m, o)
  for name = ways ()
    x = o.(name{1});
    steps = is_fixed (name{1});
    k = find (! (x > 0 & (x < 1 | steps)), 1);
    if (! isempty (k))
      error ("%s: option %s: expected %s, found %g", who, name{1}, ...
             {"tolerances above 0 and below 1", "steps above 0"}{1 + steps}, x(k));
    endif
  endfor
  if (! isempty (o.index2) && m.sizes.nlam == 0)
    error ("%s: option index2: %s has no loops; expected none, found %s", who, m.name, ...
           gs.text.shown_value (o.index2));
  endif
  [~, ~, ending] = fileparts ([o.file, ""]);
  if (! (isempty (o.file) || any (strcmpi (ending, {".png", ".pdf", ".svg", ".eps"}))))
    error ("%s: option file: the file must end in .png, .pdf, .svg or .eps, found: %s", who, ...
           o.file);
  endif
endfunction

## every run, laid out and checked before one is made
function check_runs (m, x0, times, o, rest)
  laid_out (m, x0, times, rest, "reference");
  for method = ways ()
    for step = o.(method{1})(:)'
      laid_out (m, x0, times, options_of (rest, method{1}, step), method{1});
    endfor
  endfor
endfunction

function laid_out (m, x0, times, options, name)
  who = "gsmbp_workprecision";
  try
    o = gs.given.call_options (who, gs.run.option_table (), options);
    gs.run.prepare_run (who, gs.run.plan_run (who, m, x0, times, o));
  catch err
    err.message = regexprep (err.message, "option (step|rtol)", ["option " name]);
    rethrow (err);
  end_try_catch
endfunction

## the truth
function truth = reference (m, x0, times, o, rest)
  build = fileparts (fileparts (fileparts (m.file)));
  q = gsmbp_build (m.name, "precision", "quad", "directory", m.directory, "build", build, ...
                   "parameters", m.par);
  for id = [said_once(), {"stopped"}]
    warning ("off", ["gsmbp:" id{1}], "local");
  endfor
  try
    truth = gsmbp_simulate (q, x0, times, rest{:}, "method", "dp853", "rtol", o.reference, ...
                            "atol", o.reference, "drift", false);
  catch err
    err.message = strrep (err.message, "gsmbp_simulate: ", ...
                          "gsmbp_workprecision: the reference, in quad precision: ");
    rethrow (err);
  end_try_catch
  if (any (strcmp (truth.stats.stopped, {"timeout", "interrupted"})))
    error (["gsmbp_workprecision: the reference, in quad precision, ended at t = %.9g s of " ...
            "%.9g: %s"], truth.stats.reached, times(end), truth.stats.stopped);
  endif
endfunction

## what warnings of a run tell of the scene
function list = said_once ()
  list = {"stiff", "singular", "angles", "margin", "tolerance", "events", "held"};
endfunction

## of warnings of the runs with these STATS one of each kind
function tell_once (m, stats)
  for id = said_once ()
    tell_first (m, stats, id{1});
  endfor
endfunction

function tell_first (m, stats, id)
  for other = setdiff (said_once (), {id})
    warning ("off", ["gsmbp:" other{1}], "local");
  endfor
  lastwarn ("", "");
  for s = stats
    gs.run.warn_of ("gsmbp_workprecision", m, s{1}, Inf);
    if (! isempty (lastwarn ()))
      break;
    endif
  endfor
endfunction

## those of one measurement
function options = options_of (rest, method, step)
  name = {"rtol", "step"}{1 + is_fixed(method)};
  options = [rest, {"method", method, name, step, "drift", false}];
  if (strcmp (method, "index2"))
    options = [in_index2(rest), {name, step, "drift", false}];
  endif
endfunction

function [w, stats] = measure (w, m, x0, times, o, rest, truth, method, step, span)
  for id = said_once ()
    warning ("off", ["gsmbp:" id{1}], "local");
  endfor
  options = options_of (rest, method, step);
  [r, info] = gsmbp_simulate (m, x0, times, options{:});
  stats = r.stats;
  best = r.stats.seconds;
  spent = best;
  while (spent < o.seconds)
    [again, ~] = gsmbp_simulate (m, x0, times, options{:});
    best = min (best, again.stats.seconds);
    spent += max (again.stats.seconds, 1e-4);
  endwhile
  one.method = method;
  one.step = step;
  one.calls = r.stats.calls;
  one.seconds = best / span;
  miss = Inf (1, m.sizes.nx);
  if (info == 0 && rows (r.x) == rows (truth.x))
    miss = max (abs (r.x - truth.x), [], 1);
  endif
  one.error = max (miss(1:last_measured (m)));
  one.error_states = max (miss);
  one.reference = [];
  w = [w, one];
endfunction

## the errors are those of the coordinates, where there are any
function n = last_measured (m)
  n = m.sizes.nq;
  if (n == 0)
    n = m.sizes.nx;
  endif
endfunction

## the largest of what is measured; where all of it is 0, its usual size
function most = largest (m, truth)
  n = last_measured (m);
  most = max (abs (truth.x(:,1:n)(:)));
  if (most == 0)
    most = max (m.nominal(1:n));
  endif
endfunction

## the options, with radau and the loops in index 2
function options = in_index2 (rest)
  other = reshape (rest, 2, []);
  other(:,ismember (other(1,:), {"loops", "projection"})) = [];
  options = [other(:)', {"method", "radau", "loops", "index2"}];
endfunction

## for each power of ten of the error the fastest measurement whose error is not above it
function best = best_of (w)
  best = struct ("below", {}, "method", {}, "step", {}, "seconds", {}, "error", {});
  reached = [w.error];
  powers = ceil (log10 (max (reached, 1e-17)));
  for power = sort (unique (powers), "descend")
    fit = find (reached <= 10 ^ power);
    [~, k] = min ([w(fit).seconds]);
    one = w(fit(k));
    best(end+1) = struct ("below", 10 ^ power, "method", one.method, "step", one.step, ...
                          "seconds", one.seconds, "error", one.error);
  endfor
endfunction

function show (m, w, best, span, t0)
  printf (["%s: speed against error over %g s (from t = %g s); reference: quad " "precision\n"], ...
          m.name, span, t0);
  printf ("%-8s %-12s %10s %22s %14s %14s\n", "method", "step or tol", "calls", ...
          "microseconds/second", "error coord.", "error states");
  of = {"states", "coordinates"}{1 + (m.sizes.nq > 0)};
  for one = w
    coordinates = {"-", sprintf("%.2e", one.error)}{1 + (m.sizes.nq > 0)};
    printf ("%-8s %-12.3g %10d %22.2f %14s %14.2e\n", one.method, one.step, one.calls, ...
            1e6 * one.seconds, coordinates, one.error_states);
  endfor
  for one = best
    printf ("error of %s below %g: %s with %g, %.2f microseconds/second\n", of, one.below, ...
            one.method, one.step, 1e6 * one.seconds);
  endfor
endfunction

function figure_of (file, m, w)
  methods = unique ({w.method}, "stable");
  x = 1e6 * [w.seconds]';
  y = NaN (numel (w), numel (methods));
  for k = 1:numel (methods)
    of = strcmp ({w.method}, methods{k});
    y(of,k) = max ([w(of).error]', 1e-17);
  endfor
  labels = {"rk4", "RK4"; "gauss", "Gauss"; "dp853", "DOP853"; "cvode", "CVODE"
            "radau", "Radau IIA"; "index2", "Radau IIA, index 2"};
  names = methods;
  [known, k] = ismember (methods, labels(:,1));
  names(known) = labels(k(known),2);
  label = {"largest error of a state", "largest error [rad, m]"}{1 + (m.sizes.nq > 0)};
  gsmbp_plot (file, x, struct ("y", y, "names", {names}, "label", label, "style", ...
                               "linespoints"), "xlabel",
              "compute time for 1 s [us]", "scale", "loglog", "title", [m.name ...
                    ": speed against error"], "head", "microseconds_per_second");
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! w = gsmbp_workprecision (m, [1 0 0], [0 0.5], "rk4", [1e-3 5e-4], "dp853", 1e-12, "print", ...
%!                          false, "seconds", 0);
%! assert (log2 (w(1).error / w(2).error), 4, 0.2);
%! assert (w(3).error < 1e-11);
%!error <nothing to measure: expected steps or tolerances>
%! gsmbp_workprecision (gsmbp_hand ("motor_pendulum"), [1 0 0], [0 0.5], "rk4", [], "dp853", [])
%!test <collocation of Gauss: half the step, an error much smaller>
%! m = gsmbp_hand ("motor_pendulum");
%! w = gsmbp_workprecision (m, [1 0 0], [0 0.5], "gauss", [5e-3 2.5e-3], "rk4", [], "dp853", [], ...
%!                          "print", false, "seconds", 0);
%! assert ({w.method}, {"gauss", "gauss"});
%! assert (w(1).error < 1e-6 && w(2).error < w(1).error / 3);
%!test <the best at each error is the fastest that keeps to it; radau is measured by itself>
%! m = gsmbp_hand ("motor_pendulum");
%! [w, best] = gsmbp_workprecision (m, [1 0 0], [0 0.2], "print", false, "seconds", 0);
%! assert (unique ({w.method}), {"dp853", "radau", "rk4"});
%! for one = best
%!   fit = w([w.error] <= one.below);
%!   assert (one.seconds, min ([fit.seconds]));
%!   assert (one.error <= one.below);
%! endfor
%! assert (all (diff ([best.below]) < 0) && best(end).below <= max (10 * min ([w.error]), 1e-17));
%!test
%! m = gsmbp_hand ("motor_pendulum");
%! if (! gsmbp_has_sundials ())
%!   return;
%! endif
%! s = gsmbp_workprecision (m, [1 0 0], [0 0.5], "rk4", [], "dp853", [], "cvode", [1e-5 1e-8], ...
%!                          "print", false, "seconds", 0);
%! assert ({s.method}, {"cvode", "cvode"});
%! assert (s(2).error < 0.1 * s(1).error && s(2).error < 1e-7);
