## [plan, breaks, callback] = gs.run.input_plan (who, o, m)
## What the inputs are in a run: the fields of gs_plan (share/engine/core/gsmbp/plan.h, which says
#what they # mean; [] is none) as a struct, the breaks and the function to call back.  O: the
#options of # gsmbp_simulate.  Where these numbers lie in IP and RP the run time knows alone.

function [plan, breaks, callback] = input_plan (who, o, m)
  d = m.sizes;
  plan = struct ("inputs", 0, "derivatives", m.order, "constants", [], "table", [], ...
                 "motion", [], "planned", [], "reference", [], "gain", [], "limits", [], ...
                 "memory", [], "on_the_way", 0, "instants", 0, "modes", [], "events", 0);
  callback = 0;
  if (! isempty (o.motion))
    if (! isempty (o.input))
      error ("%s: give \"input\" or \"motion\", not both", who);
    endif
    [pp, planned] = gs.given.given_motion (who, m, o.motion);
    plan.inputs = 2;
    plan.planned = planned;
    plan.motion = pieces (pp);
  elseif (isempty (o.input))
    plan.constants = zeros (1, d.nv);
  elseif (isstruct (o.input))
    plan.inputs = 1;
    if (! (isfield (o.input, "dim") && prod (o.input.dim) == d.nv))
      free = m.inputs(gs.model.free_inputs (m))';
      gs.given.given_polynomial (who, o.input, numel (free), sprintf ("the input (%s)", ...
                                                                      strjoin (free, ", ")));
    endif
    plan.table = pieces (gs.given.given_polynomial (who, o.input, d.nv, "the input"));
  elseif (is_function_handle (o.input))
    plan.inputs = 3;
    callback = o.input;
  elseif (ischar (o.input))
    if (! strcmp (o.input, "user"))
      error ("%s: input \"%s\" is not known; only \"user\" is a word here", who, o.input);
    endif
    plan.inputs = 3;
  else
    constants = o.input;
    if (! (isnumeric (constants) && isreal (constants) && numel (constants) == d.nv ...
             && isvector (constants) && all (isfinite (constants(:)))))
      free = m.inputs(gs.model.free_inputs (m))';
      error ("%s: input: %s", who, ...
             gs.text.refusal_text ("input", numel (free), strjoin (free, ", "), ...
                             "a function handle or \"user\"", gs.text.shown_value (constants)));
    endif
    plan.constants = double (constants(:)');
  endif
  if (isempty (plan.constants) && isempty (plan.table) && any (m.input_starts))
    plan.constants = m.input_starts';   # what is held before the first samples
  endif

  if (isempty (o.gain) && ! isempty (o.reference))
    error ("%s: %s", who, gs.text.refusal_text ("reference_alone"));
  endif
  if (! isempty (o.gain))
    if (isempty (o.reference))
      error ("%s: %s", who, gs.text.refusal_text ("gain_alone"));
    endif
    plan.reference = pieces (as_pp (who, o.reference, [d.nx 1], "the reference"));
    plan.gain = pieces (as_pp (who, o.gain, [d.nv d.nx], "the gain"));
  endif
  plan.limits = limits (who, m, o);
  breaks = [];
  for part = {plan.table, plan.motion, plan.reference, plan.gain}
    if (! isempty (part{1}))
      breaks = [breaks, part{1}.numbers(2:part{1}.np)];
    endif
  endfor
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
