## limits = gs.given.two_limits (who, given, names, u0)
## Lower and upper limits of the inputs NAMES in two columns; U0, their values at the trim, lie
## between them.

function limits = two_limits (who, given, names, u0)
  n = numel (names);
  if (! (isnumeric (given) && isreal (given)) || any (isnan (given(:))))
    error ("%s: option limits: expected real numbers, found %s", who, gs.text.shown_value (given));
  endif
  limits = double (given);
  if (isscalar (limits))
    limits = repmat (limits, n, 1);
  endif
  if (isvector (limits) && numel (limits) == n && ! (n == 1 && columns (limits) == 2))
    limits = [-limits(:), limits(:)];
  endif
  if (! isequal (size (limits), [n 2]))
    error ("%s: option limits: expected 1, %d or %d x 2 numbers, found %d x %d", who, n, n, ...
           size (given));
  endif
  k = find (! (limits(:,1) < limits(:,2)), 1);
  if (! isempty (k))
    error ("%s: option limits: %s: expected the lower one, then the upper; found %g and %g", ...
           who, names{k}, limits(k,:));
  endif
  k = find (! (limits(:,1) < u0 & u0 < limits(:,2)), 1);
  if (! isempty (k))
    error ("%s: option limits: %s is %g at the trim, expected between its limits; found %g and %g",
           who, names{k}, u0(k), limits(k,1), limits(k,2));
  endif
endfunction
