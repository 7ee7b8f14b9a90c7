## c = gs.linear.carried_columns (who, m, o)
## The derivatives that a run of the model M carries with its states, by the option sensitivity of
## gsmbp_simulate (O): names; columns, for each the number of its column of m.rhp, 0 for a start
## value; sizes, nominal magnitudes of these; dx0, those of the start, a column for each; fixed, 1
## for each coordinate of a closed chain that keeps them, the others follow from the constraints.

function c = carried_columns (who, m, o)
  c = struct ("names", {cellstr(o.sensitivity)(:)'}, "columns", [], "sizes", [], "dx0", [], ...
              "fixed", []);
  if (isempty (o.sensitivity))
    c.names = {};
    no_options_alone (who, o);
    return;
  endif
  can (who, m, o);
  known = cellstr (m.json.sensitivity)(:)';
  c.dx0 = start_values (who, o, m.sizes.nx, numel (c.names));
  for k = 1:numel (c.names)
    name = c.names{k};
    [is_parameter, c.columns(k)] = ismember (name, known);
    [is_state, state] = ismember (name, m.states);
    if (sum (strcmp (c.names, name)) > 1)
      error ("%s: option sensitivity: %s is given twice", who, name);
    elseif (is_parameter && moves_samples (m, name))
      error (["%s: option sensitivity: %s moves the instants of sampled devices: there are no " ...
              "derivatives by it"], who, name);
    elseif (is_parameter)
      c.sizes(k) = abs (m.par.(name)) + (m.par.(name) == 0);
    elseif (is_state)
      c.sizes(k) = m.nominal(state);
      c.dx0(state,k) += 1;
    else
      error (["%s: option sensitivity: expected parameters that %s was derived for " ...
              "(request sensitivity: %s) or states, for their start values; found %s"], ...
             who, m.name, strjoin (known, ", "), name);
    endif
  endfor
  if (m.sizes.nlam > 0)
    c.fixed = fixed_coordinates (who, m, o);
  endif
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
  elseif (ischar (o.input) || is_function_handle (o.input) && ! of_time (o.input))
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

## those of option fixed, or the actuated ones
function fixed = fixed_coordinates (who, m, o)
  names = cellstr (o.fixed)(:)';
  if (isempty (o.fixed))
    names = m.coordinates(m.actuated)(:)';
  endif
  for name = names
    if (! any (strcmp (name{1}, m.coordinates)))
      error ("%s: option fixed: unknown coordinate %s", who, ...
             gs.text.nearest_word (name{1}, m.coordinates));
    endif
  endfor
  fixed = double (ismember (m.coordinates(:)', names));
endfunction

## is an input a function of time, by its text?
function is = of_time (f)
  part = regexp (func2str (f), '^@\(\s*\w+\s*,\s*(\w+)\s*\)(.*)$', "tokens", "once");
  is = ! isempty (part) && ! any (strcmp (regexp (part{2}, '\w+', "match"), part{1}));
endfunction
