## input = gsmbp__all_inputs (m, input)
## INPUT (numbers, a piecewise polynomial or a function) for the inputs of the
## scene M that no sampled device holds and that are no modes, as one for all
## inputs, 0 in the other places.
## What is given for all inputs already comes back as it is.

function input = gsmbp__all_inputs (m, input)
  nv = m.sizes.nv;
  free = setdiff (1:nv, [vertcat(m.controllers.outputs); vertcat(m.events.input)]);
  n = numel (free);
  if (n == nv)
    return;
  endif
  if (is_function_handle (input))
    input = @(t, x) spread (input (t, x), free, nv);
  elseif (isnumeric (input) && ! isempty (input))
    input = spread (input, free, nv);
  elseif (isstruct (input) && isfield (input, "form") && strcmp (input.form, "pp") && prod (input.dim) == n)
    coefs = zeros (nv, input.pieces, input.order);
    coefs(free,:,:) = reshape (input.coefs, n, input.pieces, input.order);
    input = mkpp (input.breaks, reshape (coefs, nv * input.pieces, input.order), nv);
  endif
endfunction

function v = spread (given, free, nv)
  v = given;
  if (numel (given) == numel (free))
    v = zeros (nv, 1);
    v(free) = given;
  endif
endfunction
