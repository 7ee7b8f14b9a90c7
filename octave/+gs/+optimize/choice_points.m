## Q = gs.optimize.choice_points (P, low, high, start)
## The design P with its choices (from lists, in their order) narrowed: where LOW is HIGH, made;
## else free between both.  START: values of all free variables to begin from (left out: their own).

function Q = choice_points (P, low, high, start)
  Q = P;
  discrete = find (! cellfun (@isempty, {P.free.list}));
  made = false (1, numel (P.free));
  for k = 1:numel (discrete)
    i = discrete(k);
    f = P.free(i);
    if (strcmp (f.kind, "state"))
      error ("%s: argument free: %s: a start of a state cannot be chosen from a list", ...
             P.who, f.name);
    endif
    made(i) = low(k) == high(k);
    if (made(i))
      Q.given.(strrep (f.name, ".", "_")) = low(k);
      if (strcmp (f.kind, "parameter"))
        Q.base = gsmbp_set (Q.base, f.name, low(k));
      endif
    else
      [Q.free(i).low, Q.free(i).high] = deal (low(k), high(k));
    endif
  endfor
  if (nargin > 3)
    at = num2cell (start(:)');
    [Q.free.start] = at{:};
  endif
  for i = find (! made)
    Q.free(i).start = min (max (Q.free(i).start, Q.free(i).low), Q.free(i).high);
  endfor
  Q.places = max (min (P.places, [Q.free.high]), [Q.free.low])(:,! made);
  Q.free = Q.free(! made);
  for c = P.cases
    Q.exact.(c.name) = Q.exact.(c.name)(! made);
  endfor
  parameters = find (strcmp ({Q.free.kind}, "parameter"));
  base = Q.base;
  names = {Q.free(parameters).name};
  Q.model = @(p) with (base, names, p(parameters));
endfunction

function m = with (m, names, values)
  if (! isempty (names))
    m = gsmbp_set (m, cell2struct (num2cell (values(:)), names(:), 1));
  endif
endfunction
