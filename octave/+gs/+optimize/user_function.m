## [f, F, rough] = gs.optimize.user_function (P, row, results, p, by)
## A goal or demand that is a function of the user's: f (values) or f (values, results), with the
## derivatives by the free variables, columns, as second result, or by differences of order 4
## (ROUGH), by those of the mask BY.

function [f, F, rough] = user_function (P, row, results, p, by)
  s = gs.optimize.values_struct (P, p);
  takes = nargin (row.f);
  args = {s, results}(1:min (2, abs (takes)));
  F = [];
  try
    [f, F] = row.f(args{:});
  catch err
    if (isempty (regexp (err.message, ["undefined|too many outputs|" ...
                                       "nargout|number of output arguments"])))
      rethrow (err);
    endif
    f = row.f(args{:});
  end_try_catch
  f = f(:);
  if (! (isnumeric (f) && isreal (f) && ! isempty (f)))
    error ("%s: %s: expected real numbers, found %s", P.who, row.text, gs.text.shown_value (f));
  endif
  if (! all (isfinite (f)))
    error ("%s: %s: expected finite numbers, found %s", P.who, row.text, gs.text.shown_value (f));
  endif
  rough = isempty (F);
  if (rough)
    F = zeros (numel (f), numel (p));
    for k = find (by)
      at = @(v) again (P, row, takes, gs.optimize.replace_value (p, k, v));
      F(:,k) = gs.optimize.value_slope (P, k, at, p(k));
    endfor
  elseif (! isequal (size (F), [numel(f), numel(p)]))
    error ("%s: %s: expected derivatives of %d x %d numbers (by %s), found %d x %d", P.who, ...
           row.text, numel (f), numel (p), strjoin ({P.free.name}, ", "), rows (F), columns (F));
  endif
endfunction

function f = again (P, row, takes, p)
  s = gs.optimize.values_struct (P, p);
  if (abs (takes) < 2)
    f = row.f(s)(:);
    return;
  endif
  results = struct ();
  for c = P.cases
    results.(c.name) = gs.optimize.run_case (P, c, p);
  endfor
  f = row.f(s, results)(:);
endfunction
