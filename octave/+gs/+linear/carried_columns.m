## c = gs.linear.carried_columns (who, m, o, t0, x0, atol)
## The derivatives that a run from X0 carries with its states, by the option sensitivity of
## gsmbp_simulate (O): names; columns, for each the number of its column of m.rhp, 0 for a start
## value; x0, their start, column after column; atol, their absolute tolerances, those of the states
## ATOL beside the size of the parameter.

function c = carried_columns (who, m, o, t0, x0, atol)
  c = struct ("names", {cellstr(o.sensitivity)(:)'}, "columns", [], "x0", [], "atol", []);
  if (isempty (o.sensitivity))
    c.names = {};
    no_options_alone (who, o);
    return;
  endif
  can (who, m, o);
  d = m.sizes;
  known = cellstr (m.json.sensitivity)(:)';
  S = start_values (who, o, d.nx, numel (c.names));
  sizes = [];
  for k = 1:numel (c.names)
    name = c.names{k};
    [is_parameter, column] = ismember (name, known);
    [is_state, state] = ismember (name, m.states);
    if (sum (strcmp (c.names, name)) > 1)
      error ("%s: option sensitivity: %s is given twice", who, name);
    elseif (is_parameter && moves_samples (m, name))
      error (["%s: option sensitivity: %s moves the instants of sampled devices: there are no " ...
              "derivatives by it"], who, name);
    elseif (is_parameter)
      size_ = abs (m.par.(name)) + (m.par.(name) == 0);
    elseif (is_state)
      size_ = m.nominal(state);
      S(state,k) += 1;
    else
      error (["%s: option sensitivity: expected parameters that %s was derived for " ...
              "(request sensitivity: %s) or states, for their start values; found %s"], ...
             who, m.name, strjoin (known, ", "), name);
    endif
    c.columns(k) = column;
    sizes(k) = size_;
    c.atol = [c.atol; atol(:) / size_];
  endfor
  if (d.nlam > 0)
    S = on_constraints (who, m, o, t0, x0(:), S, c.columns);
  endif
  gs.start.starts_on_stops (who, m, t0, x0(:), c.names, S, sizes);
  c.x0 = S(:);
endfunction

function no_options_alone (who, o)
  for name = {"fixed", "dx0"}
    if (! isempty (o.(name{1})))
      error ("%s: option %s needs option sensitivity", who, name{1});
    endif
  endfor
endfunction

## an error that names what is not carried with derivatives
function can (who, m, o)
  bad = "";
  if (! any (strcmp (m.subroutines, "rhp")))
    error (["%s: option sensitivity: %s was emitted without the subroutine RHP: derive it with " ...
            "the request sensitivity(p, ...) of gsmbp_fortran"], who, m.name);
  elseif (! isempty (gs.events.missing_at_events (m)))
    error (["%s: option sensitivity needs the subroutine %s at events (request " ...
            "sensitivity), which %s was emitted without"], who, gs.events.missing_at_events (m), ...
           m.name);
  elseif (! isempty (m.controllers) && ! any (strcmp (m.subroutines, "ctd")))
    error (["%s: option sensitivity needs the subroutine CTD at samples (request " ...
            "sensitivity), which %s was emitted without"], who, m.name);
  elseif (any ([m.controllers.rounds]))
    bad = sprintf (["device %s, which rounds (the derivative of a step is 0, or none); " ...
                    "expected a variant without rounding, as plain"], ...
                   m.controllers(find ([m.controllers.rounds], 1)).name);
  elseif (! isempty (o.motion) && ! any (strcmp (m.subroutines, "cmp")))
    error (["%s: option sensitivity needs the subroutine CMP with a planned motion (request " ...
            "sensitivity), which %s was emitted without"], who, m.name);
  elseif (ischar (o.input) || is_function_handle (o.input) && ! o.of_time)
    bad = ["an input that may depend on the states; expected constants, a piecewise polynomial " ...
           "or a function @(t, x) in whose text x is not used"];
  elseif (is_function_handle (o.input) && ! isempty (o.gain))
    bad = "option gain about an input that is a function";
  elseif (! isempty (o.audit))
    bad = "option audit";
  elseif (! any (strcmp (o.loops, {"", "baumgarte", "projection"})))
    bad = sprintf ("the way %s of the loops; expected \"projection\" or \"baumgarte\"", ...
                   gs.text.shown_value (o.loops));
  endif
  if (! isempty (bad))
    error ("%s: option sensitivity: no derivatives with %s", who, bad);
  endif
endfunction

## does a parameter stand in the period or delay of a sampled device?
function is = moves_samples (m, name)
  is = false;
  for one = m.controllers(:)'
    for text = {one.period, one.delay}
      is = is || (ischar (text{1}) && any (strcmp (regexp (text{1}, '\w+', "match"), name)));
    endfor
  endfor
endfunction

## what the user says of the start, by parameters
function S = start_values (who, o, nx, n)
  S = zeros (nx, n);
  if (! isempty (o.dx0))
    if (! isequal (size (o.dx0), [nx n]))
      error ("%s: option dx0: expected %d x %d numbers (states by columns), found %d x %d", who, ...
             nx, n, size (o.dx0));
    endif
    S = double (o.dx0);
  endif
endfunction

## the start S made consistent: coordinates and speeds that are fixed keep theirs, the others follow
function S = on_constraints (who, m, o, t, x, S, columns)
  d = m.sizes;
  for name = {"con", "tan", "cop"}
    if (! any (strcmp (m.subroutines, name{1})))
      error ("%s: option sensitivity needs the subroutine %s, which %s was emitted without", ...
             who, toupper (name{1}), m.name);
    endif
  endfor
  if (d.nq != d.nu)
    error (["%s: option sensitivity: no derivatives with loops in a scene whose speeds are not " ...
            "the rates of its coordinates"], who);
  endif
  names = cellstr (o.fixed);
  what = "option fixed (default: the actuated coordinates)";
  if (isempty (o.fixed))
    names = m.coordinates(m.actuated);
    if (isempty (names))
      what = sprintf ("option fixed (no coordinate of %s is actuated: give those that keep %s)", ...
                      m.name, "their place at the start");
    endif
  endif
  q = 1:d.nq;
  u = d.nq + (1:d.nu);
  [~, ~, k] = gs.linear.independent_speeds (who, what, m, t, x(q), x(u), names);
  rest = setdiff (q, k);
  [DP, DV] = m.tan (t, x);
  [PP, PV] = m.cop (t, x);
  [~, ~, H] = m.con (t, x(q), x(u));
  PP = by_columns (PP, columns);
  PV = by_columns (PV, columns);
  positions = any (DP != 0, 2);
  S(rest,:) = -DP(positions,rest) \ (PP(positions,:) + DP(positions,k) * S(k,:));
  S(u(rest),:) = -H(:,rest) \ (PV + DV * S(q,:) + H(:,k) * S(u(k),:));
endfunction

function A = by_columns (P, columns)
  P = [zeros(rows (P), 1), P];
  A = P(:,1+columns);
endfunction
