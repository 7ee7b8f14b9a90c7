## limits = gsmbp__limits (who, m, o, n)
## The limits of gsmbp_retime as rows [least, largest]: speed and effort of N coordinates, input.

function limits = gsmbp__limits (who, m, o, n)
  limits = struct ();
  sizes = struct ("speed", n, "effort", n, "input", m.sizes.nv);
  for name = fieldnames (sizes)'
    limits.(name{1}) = rows_of (who, name{1}, o.(name{1}), sizes.(name{1}));
  endfor
  if (isempty (o.speed) && isempty (o.effort) && isempty (o.input))
    error ("%s: expected a limit: speed, effort or input", who);
  endif
  if (! isempty (o.input) && ! any (strcmp (m.subroutines, "cmq")) && m.order > 2)
    error ("%s: limits of the inputs need the subroutine CMQ, which %s has not: %s", ...
        who, m.name, ...
           gsmbp__why_left_out (m, "quasi_static"));
  endif
endfunction

function list = rows_of (who, name, value, n)
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
    error ("%s: limit %s: expected one number, %d numbers or %d x 2, found %s", who, name, n, n, ...
           gsmbp__shown (value));
  endif
  if (columns (value) == 1)
    value = [-value, value];
  endif
  if (any (value(:,1) >= value(:,2)) || any (value(:,1) > 0) || any (value(:,2) < 0))
    error ("%s: limit %s: expected a least value below the largest, 0 between them, found %s", ...
           who, name, gsmbp__shown (value));
  endif
  list = double (value);
endfunction
