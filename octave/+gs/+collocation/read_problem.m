## [p, o] = gs.collocation.read_problem (who, m, x0, xf, given)
## What gsmbp_collocate is asked for, checked.  P: x0, xf (NaN: free), t0, T (rows [least,
## largest]), low, high (of the unknowns of a point), outputs (number, low, high), goal (number,
## weight), goal_time, parameters (name, low, high), inputs, names (of the outputs); O: the other
## options.

function [p, o] = read_problem (who, m, x0, xf, given)
  table = {"time", [], "numbers"; "goal", "time", "any"; "inputs", {}, "any"; "states", {}, "any"
           "outputs", {}, "any"; "final", {}, "any"; "parameters", {}, "any"
           "method", "radau", {"lobatto", "radau"}
           "intervals", 20, "whole"; "accuracy", 1e-6, "tolerance"; "refinements", 6, "whole"
           "guess", [], "any"; "polish", true, "flag"; "regularize", 1, "nonnegative"
           "tolerance", 1e-9, "tolerance"
           "iterations", 500, "whole"; "seconds", 60, "positive"; "timeout", 0, "nonnegative"};
  o = gs.given.call_options (who, table, given);
  needed (who, m, o);
  p.x0 = ends (who, m, "x0", x0);
  p.xf = ends (who, m, "xf", xf);
  p.t0 = 0;
  p.T = duration (who, o);
  [p.goal, p.goal_time, p.final, p.own] = goal (who, m, o);
  d = m.sizes;
  states = limits (who, m, "states", o.states, m.states);
  inputs = limits (who, m, "inputs", o.inputs, m.inputs);
  inner = repmat ([-Inf, Inf], d.nu + d.nlam, 1);   # accelerations and multipliers
  p.low = [states(:,1); inner(:,1); inputs(:,1)];
  p.high = [states(:,2); inner(:,2); inputs(:,2)];
  within (who, m, "x0", p.x0, states);
  within (who, m, "xf", p.xf, states);
  p.ends = bounds (who, "final", o.final, m.states);
  p.outputs = bounds (who, "outputs", o.outputs, m.outputs);
  p.parameters = parameters (who, m, o);
  p.inputs = m.inputs(:)';
  p.names = m.outputs(:)';
endfunction

function needed (who, m, o)
  if (! any (strcmp (m.subroutines, "dah")))
    error ("%s: %s has not the subroutines DAE, DAJ, DAH: %s", who, m.name, ...
           gs.text.why_left_out (m, "collocation"));
  elseif (isfield (m.json, "controllers") && ! isempty (m.json.controllers))
    error ("%s: %s: expected a scene without sampled devices, found %s", who, m.name, ...
           m.json.controllers(1).name);
  elseif (! isempty (gs.run.switch_times (m)))
    error ("%s: %s: expected a scene that does not switch, found a switch at t = %.9g s", who, ...
           m.name, min (gs.run.switch_times (m)));
  elseif (o.intervals < 1)
    error ("%s: option intervals: expected a whole number above 0, found 0", who);
  endif
endfunction

function x = ends (who, m, name, x)
  nx = m.sizes.nx;
  if (! (isnumeric (x) && isreal (x) && numel (x) == nx && isvector (x)) ...
      || any (isinf (x)))
    error ("%s: argument %s: expected %d numbers (%s), NaN where one is free, found %s", who, ...
           name, nx, strjoin (m.states(:)', ", "), gs.text.shown_value (x));
  endif
  x = double (x(:));
endfunction

function T = duration (who, o)
  T = o.time;
  if (isempty (T))
    error (["%s: option time: expected the duration, or the least and the largest, as " ...
            "[0.1 10]; found nothing"], who);
  elseif (numel (T) > 2 || any (T <= 0) || T(end) < T(1))
    error ("%s: option time: expected the duration, or the least and the largest, found %s", ...
           who, gs.text.shown_value (T));
  endif
  T = [T(1), T(end)];
endfunction

## names and weights: of integrals of outputs, of the time, of states and outputs at the end, of
## integrals of states and inputs
function [list, by_time, final, own] = goal (who, m, o)
  d = m.sizes;
  final = struct ("x", zeros (d.nx, 1), "y", zeros (numel (m.outputs), 1));
  own = struct ("linear", zeros (d.nx + d.nu + d.nlam + d.nv, 1), "products", zeros (0, 3));
  list = struct ("number", {}, "weight", {});
  by_time = 0;
  given = o.goal;
  if (ischar (given))
    given = {given, 1};
  endif
  if (! (iscell (given) && mod (numel (given), 2) == 0 && ! isempty (given)))
    error (["%s: option goal: expected \"time\", the name of an output, state or input, or " ...
            "names and weights in turn, found %s"], who, gs.text.shown_value (o.goal));
  endif
  for k = 1:2:numel (given)
    name = given{k};
    weight = given{k+1};
    gs.given.check_kind (who, "option goal: a name", name, "text");
    gs.given.check_kind (who, ["option goal: the weight of " name], weight, "number");
    at = find (strcmp (m.outputs, name));
    if (strcmp (name, "time"))
      by_time += weight;
    elseif (strncmp (name, "final ", 6))
      final = at_end (who, m, name, weight, final);
    elseif (isempty (at))
      [own, known] = gs.collocation.cost_term (m, name, weight, own);
      if (! isempty (known))
        error ("%s: option goal: unknown %s; of states and inputs NAME^2, NAME*NAME", who, ...
               gs.text.nearest_word (name, [{"time"}, m.outputs(:)', known]));
      endif
    else
      list(end+1) = struct ("number", at, "weight", weight);
    endif
  endfor
endfunction

function final = at_end (who, m, name, weight, final)
  k = find (strcmp ([m.states(:); m.outputs(:)], name(7:end)), 1);
  if (isempty (k))
    error ("%s: option goal: unknown %s", who, ...
           gs.text.nearest_word (name, strcat ({"final "}, [m.states(:); m.outputs(:)]')));
  elseif (k <= m.sizes.nx)
    final.x(k) += weight;
  else
    final.y(k-m.sizes.nx) += weight;
  endif
endfunction

## rows [least, largest], those of the scene where none are given
function list = limits (who, m, what, given, names)
  list = gs.model.scene_limits (m, names);
  given = bounds (who, what, given, names);
  list([given.number],:) = [[given.low]', [given.high]'];
endfunction

function within (who, m, name, x, list)
  k = find (x < list(:,1) | x > list(:,2), 1);
  if (! isempty (k))
    error ("%s: argument %s: %s = %g is not within its bounds, %g to %g", who, name, ...
           m.states{k}, x(k), list(k,:));
  endif
endfunction

## rows {name, least, largest}
function list = bounds (who, what, given, names)
  list = struct ("number", {}, "low", {}, "high", {});
  if (! (isempty (given) || (iscell (given) && columns (given) == 3)))
    error ("%s: option %s: expected rows {name, least, largest}, found %s", who, what, ...
           gs.text.shown_value (given));
  endif
  for row = given'
    gs.given.check_kind (who, ["option " what ": a name"], row{1}, "text");
    k = find (strcmp (names, row{1}));
    if (isempty (k))
      error ("%s: option %s: unknown %s", who, what, gs.text.nearest_word (row{1}, names(:)'));
    endif
    pair = [row{2:3}];
    if (! (isnumeric (pair) && numel (pair) == 2 && isreal (pair) && pair(1) <= pair(2)))
      error ("%s: option %s: %s: expected the least and the largest value, found %s", who, what, ...
             row{1}, gs.text.shown_value (row(2:3)'));
    endif
    list(end+1) = struct ("number", k, "low", pair(1), "high", pair(2));
  endfor
endfunction

function list = parameters (who, m, o)
  known = cellstr (m.json.collocation.parameters);
  if (isempty (m.json.collocation.parameters))
    known = {};
  endif
  if (isempty (known) && iscell (o.parameters) && ! isempty (o.parameters))
    error (["%s: option parameters: expected names that %s was derived for (request " ...
            "sensitivity(name, ...) beside collocation), found %s; it was derived for none"], ...
           who, m.name, gs.text.shown_value (o.parameters{1}));
  endif
  given = bounds (who, "parameters", o.parameters, known);
  list = struct ("name", {}, "low", {}, "high", {});
  for k = 1:numel (known)
    value = m.par.(known{k});
    low = high = value;   # where it is not free
    for one = given([given.number] == k)
      low = one.low;
      high = one.high;
    endfor
    list(end+1) = struct ("name", known{k}, "low", low, "high", high);
  endfor
endfunction
