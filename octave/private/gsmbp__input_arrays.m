## [ip, rp, breaks, callback] = gsmbp__input_arrays (who, o, m)
## The arrays IP, RP of share/fortran/inputs/gsinp.f, the breaks and the function to call back.
## O: the options of gsmbp_simulate.

function [ip, rp, breaks, callback] = gsmbp__input_arrays (who, o, m)
  d = m.sizes;
  ip = zeros (1, 30);
  ip(4) = m.order;
  rp = breaks = [];
  callback = 0;
  if (! isempty (o.motion))
    if (! isempty (o.input))
      error ("%s: give \"input\" or \"motion\", not both", who);
    endif
    [pp, planned] = gsmbp__motion (who, m, o.motion);
    ip(1) = 2;
    ip(3) = d.nlam > 0 && numel (planned) < d.nu;
    ip(5) = numel (planned);
    ip(22) = d.nq + d.nu + 1;
    ip(30 + (1:numel (planned))) = planned;
    [ip, rp, breaks] = put (ip, rp, breaks, 10, pp);
  elseif (isempty (o.input))
    ip(9) = 1;
    rp = zeros (1, d.nv);
  elseif (isstruct (o.input))
    ip(1) = 1;
    [ip, rp, breaks] = put (ip, rp, breaks, 6, gsmbp__pp (who, o.input, d.nv, "the input"));
  elseif (is_function_handle (o.input))
    ip(1) = 3;
    callback = o.input;
  elseif (ischar (o.input))
    if (! strcmp (o.input, "user"))
      error ("%s: input \"%s\" is not known; only \"user\" is a word here", who, o.input);
    endif
    ip(1) = 3;
  else
    constants = o.input;
    if (! (isnumeric (constants) && isreal (constants) && numel (constants) == d.nv ...
             && all (isfinite (constants(:)))))
      error (["%s: input: expected %d finite numbers (%s), a piecewise polynomial, a " ...
              "function handle or \"user\", found %s"], who, d.nv, strjoin (m.inputs', ", "), ...
             gsmbp__shown (constants));
    endif
    ip(9) = 1;
    rp = double (constants(:)');
  endif

  if (isempty (o.gain) && ! isempty (o.reference))
    error ("%s: a reference needs a gain, with which the inputs follow it", who);
  endif
  if (! isempty (o.gain))
    if (isempty (o.reference))
      error ("%s: a gain needs a reference, the state about which it acts", who);
    endif
    ip(2) = 1;
    [ip, rp, breaks] = put (ip, rp, breaks, 14, ...
                            as_pp (who, o.reference, [d.nx 1], "the reference"));
    [ip, rp, breaks] = put (ip, rp, breaks, 18, as_pp (who, o.gain, [d.nv d.nx], "the gain"));
  endif
  [ip, rp] = limits (who, m, o, ip, rp);
endfunction

## what bounds the inputs of a state feedback, behind RP
function [ip, rp] = limits (who, m, o, ip, rp)
  given = o.limits;
  nv = m.sizes.nv;
  if (isempty (given))
    return;
  elseif (isempty (o.gain))
    error (["%s: option limits bounds what a state feedback gives and needs option gain; " ...
            "without feedback give an input that keeps to its limits"], who);
  elseif (! isnumeric (given) || any (isnan (given(:))) || ! isreal (given))
    error ("%s: option limits: expected real numbers", who);
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
    error ("%s: option limits: of %s the lower limit must be below the upper one; found %g and %g",
           who, m.inputs{k}, given(k,1), given(k,2));
  endif
  ip(30) = numel (rp) + 1;
  rp = [rp, max(min (given, 1e300), -1e300)(:)'];
endfunction

## a piecewise polynomial into RP, its description into IP(PLACE:PLACE+3)
function [ip, rp, breaks] = put (ip, rp, breaks, place, pp)
  ip(place:place+3) = [pp.pieces, pp.order, numel(rp) + 1, numel(rp) + numel(pp.breaks) + 1];
  rp = [rp, pp.breaks(:)', pp.coefs(:)'];
  breaks = [breaks, pp.breaks(2:end-1)(:)'];
endfunction

## a constant array as a piecewise polynomial of one piece
function pp = as_pp (who, value, dims, what)
  if (isstruct (value))
    pp = gsmbp__pp (who, value, prod (dims), what);
  elseif (isnumeric (value) ...
            && (isequal (size (value), dims) ...
                  || (dims(2) == 1 && isequal (size (value), dims([2 1])))) ...
            && all (isfinite (value(:))))
    pp = mkpp ([0 1], double (value(:)), numel (value));
  else
    error ("%s: %s: expected %d x %d finite numbers or a piecewise polynomial", who, what, dims);
  endif
endfunction
