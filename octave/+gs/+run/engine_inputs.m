## run = gs.run.engine_inputs (who, m, o, t0, x0)
## The members of gs_run_inputs (share/engine/host/run/run.h) of a run of the model M that begins at
## T0 in X0, of the options O of gsmbp_simulate; [] is none.

function run = engine_inputs (who, m, o, t0, x0)
  run = struct ("kind", 0, "constants", [], "table", [], "motion", [], "planned", [], ...
                "reference", [], "gain", [], "limits", limits (who, m, o), "function", [], ...
                "breaks", double (o.breaks(:)'));
  if (! isempty (o.motion))
    if (! isempty (o.input))
      error ("%s: give \"input\" or \"motion\", not both", who);
    endif
    [pp, run.planned] = gs.given.given_motion (who, m, o.motion);
    run.kind = 2;
    run.motion = pieces (pp);
  else
    run = own_inputs (who, m, gs.run.whole_input (who, m, o.input, t0, x0), run);
  endif
  if (isempty (run.constants) && isempty (run.table) && any (m.input_starts))
    run.constants = m.input_starts';   # what is held before the first samples
  endif
  if (is_function_handle (run.function) && ! isempty (m.controllers))
    run.constants = run.function (t0, x0)(:)';
  endif
  if (isempty (o.gain) && ! isempty (o.reference))
    error ("%s: %s", who, gs.text.refusal_text ("reference_alone"));
  elseif (! isempty (o.gain) && isempty (o.reference))
    error ("%s: %s", who, gs.text.refusal_text ("gain_alone"));
  elseif (! isempty (o.gain))
    run.reference = pieces (as_pp (who, o.reference, [m.sizes.nx 1], "the reference"));
    run.gain = pieces (as_pp (who, o.gain, [m.sizes.nv m.sizes.nx], "the gain"));
  endif
endfunction

## those of option input: constants, a piecewise polynomial, a function or "user"
function run = own_inputs (who, m, input, run)
  nv = m.sizes.nv;
  free = m.inputs(gs.model.free_inputs (m))';
  if (isempty (input))
    return;
  elseif (isstruct (input))
    if (! (isfield (input, "dim") && prod (input.dim) == nv))
      gs.given.given_polynomial (who, input, numel (free), sprintf ("the input (%s)", ...
                                                                    strjoin (free, ", ")));
    endif
    run.kind = 1;
    run.table = pieces (gs.given.given_polynomial (who, input, nv, "the input"));
  elseif (is_function_handle (input))
    run.kind = 3;
    run.function = input;
  elseif (ischar (input))
    if (! strcmp (input, "user"))
      error ("%s: input \"%s\" is not known; only \"user\" is a word here", who, input);
    endif
    run.kind = 3;
  elseif (isnumeric (input) && isreal (input) && numel (input) == nv && isvector (input) ...
            && all (isfinite (input(:))))
    run.constants = double (input(:)');
  else
    error ("%s: input: %s", who, ...
           gs.text.refusal_text ("input", numel (free), strjoin (free, ", "), ...
                           "a function handle or \"user\"", gs.text.shown_value (input)));
  endif
endfunction

## what bounds the inputs of a state feedback, NV lower limits and NV upper ones
function bounds = limits (who, m, o)
  bounds = [];
  given = o.limits;
  nv = m.sizes.nv;
  if (isempty (given))
    return;
  elseif (isempty (o.gain))
    error ("%s: option limits %s", who, gs.text.refusal_text ("limits_alone"));
  elseif (! isnumeric (given) || any (isnan (given(:))) || ! isreal (given))
    error ("%s: option limits: expected real numbers, found %s", who, gs.text.shown_value (given));
  endif
  if (isscalar (given))
    given = repmat (given, nv, 1);
  endif
  if (numel (given) == nv && (nv != 2 || isvector (given)))
    given = [-given(:), given(:)];
  endif
  if (! isequal (size (given), [nv 2]))
    error ("%s: option limits: expected 1, %d or %d x 2 numbers, found %d x %d", who, nv, nv, ...
           size (o.limits));
  endif
  k = find (! (given(:,1) < given(:,2)), 1);
  if (! isempty (k))
    error ("%s: option limits: %s", who, ...
           gs.text.refusal_text ("limits_order", m.inputs{k}, given(k,1), given(k,2)));
  endif
  bounds = max (min (given, 1e300), -1e300)(:)';
endfunction

## a piecewise polynomial as gs_pieces
function p = pieces (pp)
  p = struct ("nc", prod (pp.dim), "np", pp.pieces, "k", pp.order, ...
              "numbers", [pp.breaks(:)', pp.coefs(:)']);
endfunction

## a constant array as a piecewise polynomial of one piece
function pp = as_pp (who, value, dims, what)
  if (isstruct (value))
    pp = gs.given.given_polynomial (who, value, prod (dims), what);
  elseif (isnumeric (value) ...
            && (isequal (size (value), dims) ...
                  || (dims(2) == 1 && isequal (size (value), dims([2 1])))) ...
            && all (isfinite (value(:))))
    pp = mkpp ([0 1], double (value(:)), numel (value));
  else
    error ("%s: %s: %s", who, what, gs.text.refusal_text ("matrix", dims, ...
                                                          gs.text.shown_value (value)));
  endif
endfunction
