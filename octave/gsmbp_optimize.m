## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{r} =} gsmbp_optimize (@var{m}, @var{free}, @var{goal}, @var{demands}, @
## @var{cases}, @var{options}, @dots{})
## @deftypefnx {} {[@var{r}, @var{info}] =} gsmbp_optimize (@dots{})
## The best design of a machine: parameters, starts, motions and gains that make a goal small and
## meet demands in load cases.
##
## @var{free} says what may change, a cell array with a row for each variable:
## @code{@{"k", 10, [1 100]@}} (name, start, bounds; -Inf, Inf: none) or
## @code{@{"n", 20, @{10, 20, 50@}@}} (one of a list).  A name is that of a parameter of the model
## @var{m}, of a state (its start in runs), or one of your own, for your functions.
##
## @var{cases} is a list of load cases, each a list of what another function is called with:
## @table @code
## @item @{"run", times, x0, @dots{}@}
## a run; options of @code{gsmbp_simulate}.  With loops @code{x0} is closed with the actuated
## coordinates (or those of "fixed") held.  @code{end_time} [s]: when an event of the scene has
## ended it, else the last of the times; rows behind such an end are as the last one
## @item @{"inverse", motion, times, @dots{}@}
## efforts and inputs along a motion; options of @code{gsmbp_inverse}
## @item @{"rest", x, v, @dots{}@}
## an equilibrium; options of @code{gsmbp_trim}; also @code{frequency1},
## @code{damping1}, @dots{} of its oscillations and @code{decay} [1/s] of what dies out last
## @item @{"positions", names, values, @dots{}@}
## one position after the other, at rest: coordinates that are held and their values, a row each;
## option "guess", coordinates from which the loops are closed
## @item @{"loop", controller@}
## a control loop (@code{gsmbp_control}, @code{gsmbp_pid}), mostly a function of the values, or of
## them and the model: @code{phase_margin} [rad], @code{gain_margin}, @code{delay_margin} [s] and
## @code{Ms}, the worst of all inputs (@code{gsmbp_loop}; 1e6 where there is none)
## @end table
## Any argument may be a function of one argument, the struct of the values by name: the
## coefficients of a plan, gains, a start.  More options of a case: "name", "target" (a struct by
## names: a number, one for each time, a piecewise polynomial or a function of the time), "band"
## (0.02).
##
## @var{goal} has rows @code{@{word, name@}} or @code{@{word, name, factor@}}, which are added (a
## negative factor: as large as possible); @var{demands} rows @code{@{word, name, relation, bound@}}
## with the relation "<", ">" or "=".  The name of a case behind a row: of that case alone.  Names
## are those of @code{gsmbp_names}, products of them ("motor.v*motor.i"), "error.q": less its
## target, and in runs "state_margin2", the second of @code{m.state_margins}.
## @table @code
## @item start, end, mean, integral, square, rms
## over the times of a case (square: the mean of squares)
## @item drawn
## the integral where it is positive: energy that is not given back
## @item peak, max, min, each
## largest modulus, largest, least; each: at every time
## @item settling
## the time until the modulus stays below "band" times its first value, which is not 0; where it
## does not by the end of the times a number above all of them, the larger the farther it is outside
## @item value
## of a free variable or parameter
## @item mass
## of links [kg]: "all" of them, or names ("arm, fore"); its derivatives are exact
## @end table
## A row may also be a function, @code{@{f@}}, @code{@{f, factor@}}, @code{@{f, relation, bound@}},
## of the struct of the values, or of that and of the results of the cases by name; its second
## result, if it has one, are its derivatives by the variables (columns).
##
## Derivatives are exact where @var{m} was derived for its parameters (request
## @code{sensitivity(@dots{})}): states and outputs of runs with given inputs or feedback (by
## gains where these are parameters of a controller in the scene), equilibria,
## positions, efforts along motions and positions, through loops too; else differences of order 4,
## and @code{r.derivatives} says so.
##
## Options: "solver": "auto" (default), "slsqp", "mma", "cobyla" (NLopt, Debian package
## libnlopt-dev) or "ipopt" (coinor-libipopt-dev); "starts": how many places to start from, 1 or
## more, by chance within the bounds, and "seed" of that chance, or a matrix, a row of values for
## each further start; "tolerance" (1e-10); limits
## "iterations" (500), "evaluations" (1000), "seconds" (Inf), each for a start, and "timeout" [s]
## (0: none), of all together.  "choices": all
## combinations of the lists ("all", at most 1000) or "branch", branch and bound: choices are free
## between two numbers of their lists first, and what cannot be better than the best found is left
## out; as sure as the solutions of these relaxed problems are the best ones ("starts").  "auto"
## (default): all up to 100 combinations.  "nodes" (1000): a limit of the problems that are solved.
##
## @var{r} has the fields @code{values} (by name), @code{J}, @code{model} (with these values),
## @code{results} of the cases, @code{active} (bounds and demands that hold it back: text, value,
## bound, multiplier: how much the goal falls for each unit that it is loosened, of an equation how
## much it rises for each unit that its bound rises; NaN where all is chosen), @code{solved},
## @code{ended}, @code{limit} (a limit was reached), @code{violation} and @code{optimality} (what is
## left of the conditions of an optimum, beside their sizes), @code{stopped} ("interrupted" by
## Ctrl-C or "timeout": the best so far, with a warning; else ""), @code{iterations},
## @code{evaluations}, @code{starts} (all ends), @code{derivatives}, @code{report} (a text),
## @code{choices} (how the lists were searched, combinations, problems solved).
##
## Demands that cannot be met are an error that names a least set of them which contradict each
## other; with @var{info} it is no error: 0 solved, 1 a limit was reached, 2 the demands
## contradict each other (@code{r.conflict}), 3 the solver ended elsewhere; 1 and 3 are warnings
## too.
##
## @c session octave
## @example
## >> file = fopen ("swing.mac", "w");
## >> fputs (file, "scene : gsmbp_scene(\"swing\", gravity = [0, -g, 0], ");
## >> fputs (file, "link(rod, mass = m, centre = [l, 0, 0], inertia = [0, 0, 0.01]), ");
## >> fputs (file, "revolute(A, ground, rod, axis = z, coordinate = q), ");
## >> fputs (file, "input(tau, unit = N*m), drive(motor, joint = A, effort = tau), ");
## >> fputs (file, "parameters = [g = 9.81, m = 2*kg, l = 0.5*m])$ ");
## >> fputs (file, "requests : '[all, adjoint, sensitivity(m, l)]$");
## >> fclose (file);
## >> gsmbp_derive ("swing.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("swing");
## >> free = @{"l", 0.5, [0.1 1]@};
## >> held = @{"positions", "q", 0@};
## >> r = gsmbp_optimize (m, free, @{"value", "l", -1@}, @{"max", "effort.q", "<", 4@}, held);
## >> abs (r.values.l - 4 / (2 * 9.81)) < 1e-8
## ans = 1
## >> r.active.text
## ans = max effort.q < 4
## @end example
##
## Errors: unknown names and words; a solver that is not installed; demands that contradict each
## other; a variable on which nothing depends.
## Source: own glue; solvers: Kraft (1994), SLSQP, in
## NLopt (S. G. Johnson); Waechter and Biegler (2006), Ipopt.
## @seealso{gsmbp_sensitivity, gsmbp_adjoint, gsmbp_simulate, gsmbp_inverse}
## @end deftypefn

function [r, info] = gsmbp_optimize (m, free, goal, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_optimize";
  gs.given.check_model (who, m);
  given = [varargin, cell(1, max (0, 2 - numel (varargin)))];
  o = gs.given.call_options (who, known_options (), given(3:end));
  P = problem (who, m, free, goal, given{1:2});
  checked (P, o);
  P.ends = time () + {o.timeout, Inf}{1 + (o.timeout == 0)};
  at = @(p, rows, by) m.module ("guarded", @() gs.optimize.row_values (P, p', rows, by), ...
                                P.ends - time ());
  s = m.module ("design", who, engine_problem (P), at, search_options (who, P, o));
  gs.run.stopped_word (who, m, 9 * strcmp (s.stopped, "interrupted"), "", false);
  [r, info] = gs.optimize.design_result (P, s);
  if (nargout < 2 && info == 2)
    error ("gsmbp:infeasible", "%s: %s: %s", who, m.name, r.ended);
  elseif (any (info == [1, 3]))
    warning ("gsmbp:optimize", "%s: %s: no optimum was found: %s", who, m.name, r.ended);
  endif
endfunction

function table = known_options ()
  table = {"solver", "auto", {"auto", "slsqp", "mma", "cobyla", "ipopt"}
           "starts", 1, "numbers"
           "seed", 1, "whole"
           "tolerance", 1e-10, "tolerance"
           "iterations", 500, "whole"
           "evaluations", 1000, "whole"
           "seconds", Inf, "any"
           "timeout", 0, "nonnegative"
           "choices", "auto", {"auto", "all", "branch"}
           "nodes", 1000, "whole"};
endfunction

## as the engine takes it (glue/design.h)
function p = engine_problem (P)
  rows_ = P.rows;
  words = gs.text.table_rows ("GS_DESIGN_WORDS");
  number = num2cell (numel (words) * ones (1, numel (rows_)));
  for k = 1:numel (rows_)
    if (isempty (rows_(k).f))
      number{k} = find (strcmp (words, rows_(k).word)) - 1;
    endif
  endfor
  rows_ = rmfield (rows_, {"f", "word", "name"});
  [rows_.number] = number{:};
  p = struct ("name", P.base.name, "free", {P.free}, "rows", {rows_}, "goals", numel (P.goal), ...
              "bands", [P.cases.band], "why", strjoin (P.why, "; "));
endfunction

function e = search_options (who, P, o)
  word = @(table, word) find (strcmp (gs.text.table_rows (table), word)) - 1;
  e = struct ("solver", word ("GS_DESIGN_SOLVERS", o.solver), ...
              "choices", word ("GS_DESIGN_CHOICES", o.choices), "nodes", o.nodes, ...
              "iterations", o.iterations, "starts", further (P, o), "tolerance", o.tolerance, ...
              "evaluations", o.evaluations, "seconds", o.seconds, "timeout", o.timeout);
  for name = {"ipopt", "nlopt"}
    e.(name{1}) = library (who, P.base, name{1});
  endfor
endfunction

## "" where it is not installed
function file = library (who, m, name)
  file = "";
  try
    file = gs.model.host_library (who, m, name);
  catch err
    if (isempty (strfind (err.message, gs.text.refusal_text (["no_" name]))))
      rethrow (err);
    endif
  end_try_catch
endfunction

function P = problem (who, m, free, goal, demands, cases)
  P.who = who;
  P.free = gs.optimize.free_variables (who, m, free);
  P.cases = gs.optimize.read_cases (who, m, cases);
  P.goal = gs.optimize.goal_rows (who, "goal", goal, P.cases, true);
  P.demands = gs.optimize.goal_rows (who, "demands", demands, P.cases, false);
  P.rows = P.goal;   # [a, b] of two without rows has no fields
  P.rows(end+(1:numel (P.demands))) = P.demands;
  P.table = gs.model.name_table (m);
  P.also = {};
  if (any (strcmp ({P.cases.kind}, "rest")))
    P.also = {"frequency1", "damping1", "decay"};
  endif
  if (any (strcmp ({P.cases.kind}, "run")))
    P.also{end+1} = "end_time";
  endif
  if (any (strcmp ({P.cases.kind}, "loop")))
    P.also = [P.also, {"phase_margin", "gain_margin", "delay_margin", "Ms"}];
  endif
  P.base = m;
  P.why = {};
  for c = P.cases
    [P.exact.(c.name), why] = gs.optimize.exact_slopes (m, P.free, c, fields (P, c));
    if (! isempty (why))
      P.why{end+1} = why;
    endif
  endfor
endfunction

## the fields of a case's result that goals and demands read
function list = fields (P, c)
  list = {};
  for row = P.rows
    if (isempty (row.name) || any (strcmp (row.word, {"value", "mass"})) ...
        || ! any (strcmp ({P.cases(row.cases).name}, c.name)))
      continue;
    endif
    for name = strtrim (strsplit (row.name, "*"))
      plain = regexprep (name{1}, '^error\.', "");
      k = find (strcmp ({P.table.name}, plain));
      if (! isempty (k))
        list{end+1} = P.table(k).field;
      elseif (! isempty (regexp (plain, ['^(decay|(frequency|damping)\d+|Ms|end_time|' ...
                                         '(phase|gain|delay)_margin)$'], "once")))
        list{end+1} = "extra";
      elseif (! isempty (regexp (plain, '^state_margin\d+$', "once")))
        list{end+1} = "state_margins";
      else
        error ("%s: case %s: unknown quantity %s", P.who, c.name, ...
               gs.text.nearest_word (name{1}, [{P.table.name}, P.also]));
      endif
    endfor
  endfor
  list = unique (list);
endfunction

## further starts, a column each: given, or by chance within the bounds
function places = further (P, o)
  low = [P.free.low]';
  high = [P.free.high]';
  if (! isscalar (o.starts))
    places = given_starts (P, o);
    return;
  endif
  before = rand ("state");
  guard = onCleanup (@() rand ("state", before));
  rand ("state", o.seed);
  places = low + (high - low) .* rand (numel (low), max (0, o.starts - 1));
endfunction

function places = given_starts (P, o)
  places = o.starts;
  if (columns (places) != numel (P.free))
    error (["%s: option starts: expected a row for each further start, %d numbers (%s), " ...
            "found %d columns"], P.who, numel (P.free), strjoin ({P.free.name}, ", "), ...
           columns (places));
  endif
  [k, i] = find (! (places >= [P.free.low] & places <= [P.free.high]), 1);
  if (! isempty (k))
    error ("%s: option starts: row %d: expected %s from %g to %g, found %g", P.who, k, ...
           P.free(i).name, P.free(i).low, P.free(i).high, places(k,i));
  endif
  places = places';
endfunction

function checked (P, o)
  if (isscalar (o.starts) && ! (o.starts >= 1 && o.starts == fix (o.starts)))
    error ("%s: option starts: expected a whole number, at least 1, found %g", P.who, o.starts);
  elseif (! (isnumeric (o.seconds) && isscalar (o.seconds) && o.seconds > 0))
    error ("%s: option seconds: expected a number above 0, found %s", P.who, ...
           gs.text.shown_value (o.seconds));
  endif
  if (o.nodes < 1)
    error ("%s: option nodes: expected at least 1, found %d", P.who, o.nodes);
  endif
  endless = find (! isfinite ([P.free.high] - [P.free.low]), 1);
  if (isscalar (o.starts) && o.starts > 1 && ! isempty (endless))
    error ("%s: option starts: expected finite bounds of %s, between which to start", P.who, ...
           P.free(endless).name);
  endif
endfunction

%!shared m
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%!error <unknown word "peek", did you mean "peak"> 
%! gsmbp_optimize (m, {"g", 9.81, [1 20]}, {"peek", "q"}, {}, {"run", [0 1], [0 0 0]})
%!error <option solver: expected one of>
%! gsmbp_optimize (m, {"g", 9, [1 20]}, {}, {}, {}, "solver", 1)
