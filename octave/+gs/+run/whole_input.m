## input = gs.run.whole_input (who, m, input, t, x)
## INPUT (numbers, also by name, a piecewise polynomial or a function) for the inputs of the
## scene M that no sampled device holds and that are no modes, as one for all
## inputs, in the other places what m.input_starts says (0 but for controllers about a trim).
## What is given for all inputs already comes back as it is.  A function is called at the time
## T and the state X to see that it gives what it must.

function input = whole_input (who, m, input, t, x)
  nv = m.sizes.nv;
  free = gs.model.free_inputs (m);
  n = numel (free);
  if (isempty (input) && any (m.input_starts))
    input = m.input_starts;
    return;
  endif
  if (iscell (input) || (isstruct (input) && ! isfield (input, "form")))
    gs.given.refuse_mode_names (who, "option input", m, input);
    input = gs.given.values_by_names (who, "option input", input, m.inputs(free));
  endif
  if (is_function_handle (input))
    f = input;
    input = @(t, x) called (who, m, f, free, t, x);
    input (t, x);
  elseif (n == nv)
    return;
  elseif (isnumeric (input) && isreal (input) && isvector (input) && all (isfinite (input)))
    input = spread (input, free, m.input_starts);
  elseif (isstruct (input) && isfield (input, "form") && strcmp (input.form, "pp") ...
            && prod (input.dim) == n)
    coefs = zeros (nv, input.pieces, input.order);
    coefs(:,:,end) = repmat (m.input_starts, 1, input.pieces);
    coefs(free,:,:) = reshape (input.coefs, n, input.pieces, input.order);
    input = mkpp (input.breaks, reshape (coefs, nv * input.pieces, input.order), nv);
  endif
endfunction

function v = spread (given, free, starts)
  v = given;
  if (numel (given) == numel (free))
    v = starts;
    v(free) = given;
  endif
endfunction

## what the user's function gives, in all places
function v = called (who, m, f, free, t, x)
  try
    given = f (t, x(1:m.sizes.nx));
  catch err
    said = strtrim (strrep (err.message, "\n", " "));
    refuse (who, m, free, t, sprintf ("it ends with the error \"%s\"", said));
  end_try_catch
  n = numel (given);
  if (! ((isnumeric (given) || islogical (given)) && isreal (given) ...
         && (n == numel (free) || n == m.sizes.nv)))
    refuse (who, m, free, t, ["it gives " gs.text.shown_value(given)]);
  endif
  v = double (given(:));
  if (! all (abs (v) <= 1e300))
    refuse (who, m, free, t, ["it gives " gs.text.shown_value(given) ", which is not finite"]);
  elseif (n < m.sizes.nv)
    v = spread (v, free, m.input_starts);
  endif
endfunction

function refuse (who, m, free, t, found)
  n = numel (free);
  names = {sprintf(" (%s)", strjoin (m.inputs(free)', ", ")), ""}{1 + (n == 0)};
  error ("gsmbp:input",
         ["%s: option input: expected a function v = f (t, x) of the time and the %d states " ...
          "that gives %d finite number%s%s; found at t = %.9g s: %s"],
         who, m.sizes.nx, n, {"s", ""}{1 + (n == 1)}, names, t, found);
endfunction
