## [exact, why] = gs.optimize.exact_slopes (m, free, c, fields)
## By which of the free variables a load case of the model M has exact derivatives of these fields
## of its result (a mask; what comes in by functions of the user's apart), and why not by all.

function [exact, why] = exact_slopes (m, free, c, fields)
  why = "";
  has = @(varargin) all (ismember (varargin, m.subroutines));
  can = @(varargin) all (ismember (fields, varargin));
  loops = m.sizes.nlam > 0;
  outputs = ! any (strcmp (fields, "y")) || has ("jac", "oup");
  by_motion = m.sizes.nx == m.sizes.nq + m.sizes.nu;
  switch (c.kind)
    case "run"
      possible = can ("x", "y", "v", "extra") && has ("rhp") && outputs ...
                 && plain_run (m, c) ...
                 && (! loops || (has ("con", "tan", "cop") && m.sizes.nq == m.sizes.nu));
    case "inverse"
      possible = m.sizes.nq == m.sizes.nu && isempty (c.options) ...
                 && (can ("tau", "lambda") || (by_motion && can ("x", "tau", "lambda")) ...
                     || (has ("cmj") && isempty (m.internal) && outputs ...
                         && can ("x", "v", "y", "tau", "lambda"))) ...
                 && ((! loops && has ("inv", "lin", "inp")) ...
                     || (has ("ilp") && plans_actuated (m, c)));
    case "loop"
      possible = false;
    case "rest"
      possible = can ("x", "y", "v", "extra") && has ("rhp", "jac") && outputs;
    case "positions"
      possible = outputs && m.sizes.nq == m.sizes.nu && ((! loops && can ("x", "y", "tau") ...
                              && has ("lin", "inp")) || (can ("x", "y") && has ("tan", "cop")) ...
                     || (can ("x", "y", "tau", "lambda") && has ("tan", "cop", "ilp")));
  endswitch
  known = {};
  if (isfield (m.json, "sensitivity"))
    known = cellstr (m.json.sensitivity);
  endif
  exact = possible & (strcmp ({free.kind}, "own") | ismember ({free.name}, known) ...
                      | (strcmp ({free.kind}, "state") & strcmp (c.kind, "run")));
  if (! possible)
    why = sprintf ("no exact derivatives of %s in case %s (%s)", strjoin (fields, ", "), c.name, ...
                   c.kind);
  elseif (! all (exact))
    why = sprintf ("%s was not derived for %s (request sensitivity)", m.name, ...
                   strjoin ({free(! exact).name}, ", "));
  endif
endfunction

## whether the motion is that of the actuated coordinates alone
function yes = plans_actuated (m, c)
  motion = c.args{1};
  yes = gs.optimize.is_of_values (motion);
  if (! yes)
    pp = gs.given.given_polynomial ("gsmbp_optimize", motion);
    yes = prod (pp.dim) == m.sizes.nact;
  endif
endfunction

## a run that carries derivatives: what gsmbp_simulate says of the option sensitivity
function yes = plain_run (m, c)
  has = @(varargin) all (ismember (varargin, m.subroutines));
  yes = isempty (gs.events.missing_at_events (m)) && (! gs.events.may_end (m) || ...
                                                      constant_inputs (c)) ...
        && (isempty (m.controllers) || (has ("ctd") && ! any ([m.controllers.rounds])));
  for k = 1:2:numel (c.options)
    value = c.options{k+1};
    switch (c.options{k})
      case "audit"
        yes = false;
      case "motion"
        yes = yes && has ("cmp");
      case "loops"
        yes = yes && any (strcmp (value, {"baumgarte", "projection"}));
      case "input"
        yes = yes && ! ischar (value) && (! is_function_handle (value) || nargin (value) == 1);
    endswitch
  endfor
endfunction

## do the inputs of a run stay as they are? (The rate of what they become at its end is 0.)
function yes = constant_inputs (c)
  yes = ! any (ismember (c.options(1:2:end), {"motion", "gain"}));
  k = find (strcmp (c.options(1:2:end), "input"), 1);
  if (! isempty (k))
    yes = yes && (isnumeric (c.options{2*k}) || is_function_handle (c.options{2*k}));
  endif
endfunction
