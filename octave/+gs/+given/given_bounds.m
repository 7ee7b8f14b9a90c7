## list = gs.given.given_bounds (who, what, value, n)
## Limits that the user gave as rows [least, largest] of N quantities: one number or one for each
## (both ways), or two for each; none where VALUE is empty.  WHAT: how an error of WHO calls them.

function list = given_bounds (who, what, value, n)
  if (isempty (value))
    list = [-Inf(n, 1), Inf(n, 1)];
    return;
  endif
  if (isscalar (value))
    value = repmat (value, n, 1);
  elseif (isvector (value) && numel (value) == n)
    value = value(:);
  endif
  if (! (isnumeric (value) && isreal (value) && rows (value) == n && columns (value) <= 2 ...
         && ! any (isnan (value(:)))))
    error ("%s: %s: expected one number, %d numbers or %d x 2, found %s", who, what, n, n, ...
           gs.text.shown_value (value));
  endif
  if (columns (value) == 1)
    value = [-value, value];
  endif
  if (any (value(:,1) >= value(:,2)) || any (value(:,1) > 0) || any (value(:,2) < 0))
    error ("%s: %s: expected a least value below the largest, 0 between them, found %s", ...
           who, what, gs.text.shown_value (value));
  endif
  list = double (value);
endfunction
