## [R, D, rough] = gs.optimize.run_case (P, c, p, by)
## What a load case C gives with the values P of the free variables (of the problem P): a struct R
## with the times t, the weights w of an integral over them, and matrices x, v, y, points, tau,
## lambda, margins (a row for each time), and extra, a struct of numbers by names.  D: the same
## fields with a page for each free variable, those of the mask BY are filled.  ROUGH: which of
## these were taken by differences.
## Rows of a run behind the event that ends it repeat its last row, at weight 0.

function [R, D, rough] = run_case (P, c, p, by)
  if (nargout < 2)
    R = weighted (P, c, values (P, c, p, false));
    return;
  endif
  rough = by & by_differences (P, c, p);
  [R, D] = values (P, c, p, by & ! rough);
  R = weighted (P, c, R);
  if (strcmp (c.kind, "rest"))
    rough |= unknown (D, numel (p));
  endif
  for k = find (rough)
    D = put (D, differenced (P, c, p, k), k, numel (p));
  endfor
endfunction

## [R, D] = values: exact derivatives by the variables of the mask BY; errors name the case
function [R, D] = values (P, c, p, by)
  try
    [R, D] = calculated (P, c, p, by);
  catch err
    if (! strncmp (err.message, P.who, numel (P.who)))
      err.message = sprintf ("%s: case %s: %s", P.who, c.name, err.message);
    endif
    rethrow (err);
  end_try_catch
endfunction

function [R, D] = calculated (P, c, p, by)
  D = struct ();
  given = gs.optimize.fill_arguments ([c.args, c.options], p, P);
  args = given(1:numel (c.args));
  options = given(numel (c.args)+1:end);
  m = gs.optimize.design_model (P, p);
  switch (c.kind)
    case "run"
      [R, D] = simulated (P, m, args, options, p, by);
    case "inverse"
      R = gsmbp_inverse (m, args{:}, options{:});
      R.t = R.t(:);
      if (any (by))
        D = gs.optimize.inverse_slopes (P, c, m, R, p, by);
      endif
    case "rest"
      [R, D] = rest (P, m, args, options, p, by);
    case "positions"
      [R, D] = gs.optimize.position_case (P, m, c, args, options, p, by);
    case "loop"
      R = loop (P, m, args{1}, p);
  endswitch
endfunction

## the free variables that only differences can do: where a function of the user's depends on
## them, and all, where a quantity has no exact derivatives
function rough = by_differences (P, c, p)
  rough = ! P.exact.(c.name);
  if (all (rough))
    return;
  endif
  handles = [c.args, c.options(! leading (c.options, "guess"))];   # it tells a branch, no more
  if (strcmp (c.kind, "inverse"))
    handles(1) = [];   # through the equations of motion
  elseif (strcmp (c.kind, "positions"))
    handles(2) = [];   # through the constraints
  endif
  handles = handles(cellfun (@gs.optimize.is_of_values, handles));
  for h = handles
    here = h{1}(gs.optimize.values_struct (P, p));
    for k = find (! rough)
      q = p;
      v = P.free(k);
      q(k) = P.base.module ("differences", v.start, v.low, v.high, p(k))(end);
      rough(k) = ! isequal (here, h{1}(gs.optimize.values_struct (P, q)));
    endfor
  endfor
endfunction

function [R, D] = simulated (P, m, args, options, p, by)
  D = struct ();
  x0 = args{2}(:);
  for k = find (strcmp ({P.free.kind}, "state"))
    x0(strcmp (m.states, P.free(k).name)) = p(k);
  endfor
  if (m.sizes.nlam > 0)
    held = m.coordinates(m.actuated);
    at = find (strcmp (options(1:2:end), "fixed"));
    if (! isempty (at))
      held = options{2*at};
    endif
    x0 = gsmbp_assemble (m, x0, "hold", held);
  endif
  by &= ! strcmp ({P.free.kind}, "own");
  names = {P.free(by).name};
  if (isempty (names))
    R = with_margins (m, gsmbp_simulate (m, x0, args{1}, options{! leading(options, "fixed")}));
    R = gs.optimize.end_slopes (m, R, numel (args{1}), names);
    return;
  endif
  R = with_margins (m, gsmbp_simulate (m, x0, args{1}, options{:}, "sensitivity", names));
  [R, parts] = gs.optimize.end_slopes (m, R, numel (args{1}), names);
  pages = find (by);
  for k = 1:numel (names)
    D = put (D, parts(k), pages(k), numel (p));
  endfor
endfunction

## the margins of a control loop: the worst of its inputs
function R = loop (P, m, law, p)
  if (is_function_handle (law))
    law = law(gs.optimize.values_struct (P, p), m);
  endif
  R = struct ("t", 0, "extra", gs.control.least_margins (law));
endfunction

## the margins of its devices along a run (m.state_margins)
function R = with_margins (m, R)
  if (any (strcmp (m.subroutines, "mar")))
    R.state_margins = m.module ("margins", m.cst, numel (R.t), R.t(:), R.x, R.v)';
  endif
endfunction

## the places of an option and its value
function is = leading (options, name)
  is = false (1, numel (options));
  k = find (strcmp (options(1:2:end), name));
  is([2*k-1, 2*k]) = true;
endfunction

function [R, D] = rest (P, m, args, options, p, by)
  D = struct ();
  e = gsmbp_trim (m, args{:}, options{:});
  R = struct ("t", 0, "x", e.x', "v", e.v', "y", gs.run.output_values (m, 0, e.x', e.v'));
  R = gs.model.named_results (m, R);
  R.extra = struct ();
  keep = ismember (options(1:2:end), {"hold", "free", "time"});
  keep = reshape ([keep; keep], 1, []);
  if (! any (strcmp (m.subroutines, "rhp")))
    at = [options(find (strcmp (options(1:2:end), "time")) * 2), {0}]{1};
    R.extra = of_vibrations (gs.linear.state_poles (P.who, m, at, e.x, e.v));
    return;
  endif
  s = gsmbp_sensitivity (m, e.x, e.v, options{keep});
  R.extra = of_vibrations (s);
  [~, slow] = max (real (s.poles));
  for k = find (by & strcmp ({P.free.kind}, "parameter"))
    name = P.free(k).name;
    one = struct ("x", s.dx.(name)', "v", s.dv.(name)', "y", s.dy.(name)');
    one.extra = of_vibrations (struct ("poles", s.dpoles.(name)(slow), ...
                                       "frequency", s.dfrequency.(name), ...
                                       "damping", s.ddamping.(name)));
    D = put (D, one, k, numel (p));
  endfor
endfunction

## the free variables by which a pole has no derivative: a multiple one
function is = unknown (D, n)
  is = false (1, n);
  if (isfield (D, "extra"))
    for value = struct2cell (D.extra)'
      is |= isnan (reshape (value{1}, 1, n));
    endfor
  endif
endfunction

## numbers of an equilibrium by name
function extra = of_vibrations (s)
  extra = struct ();
  if (! isempty (s.poles))
    extra.decay = -max (real (s.poles));
  endif
  for i = 1:numel (s.frequency)
    extra.(sprintf ("frequency%d", i)) = s.frequency(i);
    extra.(sprintf ("damping%d", i)) = s.damping(i);
  endfor
endfunction

## the weights of an integral over the times; of single positions and equilibria their mean
function R = weighted (P, c, R)
  n = numel (R.t);
  if (! any (strcmp (c.kind, {"run", "inverse"})))
    R.w = ones (n, 1) / n;
  elseif (! isfield (R, "w"))
    R.w = P.base.module ("weights", R.t(:));
  endif
  if (! isfield (R, "extra"))
    R.extra = struct ();
  endif
endfunction

## page K of N of the derivatives
function D = put (D, one, k, n)
  for name = fieldnames (one)'
    name = name{1};
    value = one.(name);
    if (isstruct (value))
      if (! isfield (D, name))
        D.(name) = struct ();
      endif
      D.(name) = put (D.(name), value, k, n);
    elseif (isnumeric (value))
      if (! isfield (D, name))
        D.(name) = zeros ([size(value), n]);
      endif
      D.(name)(:,:,k) = value;
    endif
  endfor
endfunction

## by one variable, differences of order 4
function D = differenced (P, c, p, k)
  at = @(s) fields_of (values (P, c, gs.optimize.replace_value (p, k, s), false (1, numel (p))));
  D = gs.optimize.value_slope (P, k, at, p(k));
endfunction

## the fields that are numbers
function F = fields_of (R)
  F = struct ();
  for name = {"x", "v", "y", "points", "tau", "lambda", "margins", "state_margins", "extra", ...
              "w", "t"}
    if (isfield (R, name{1}))
      F.(name{1}) = R.(name{1});
    endif
  endfor
endfunction
