## value = gsmbp__value (m, row, x)
## The expression ROW.value of the JSON in the parameters p1, p2, ... named by
## ROW.parameters, with the values m.par, and in states x1, x2, ..., with the values X.

function value = gsmbp__value (m, row, x)
  p = {};
  if (! isempty (row.parameters))
    names = cellstr (row.parameters);
    for k = 1:numel (names)
      p{k} = m.par.(names{k});
    endfor
  endif
  f = function_of (row.value);
  value = double (f (p, x));
endfunction

## the expression as a function; to make one takes much longer than to call it
function f = function_of (expression)
  persistent made = struct ();
  if (! isfield (made, expression))
    if (numfields (made) >= 2000)
      made = struct ();
    endif
    text = regexprep (expression, {'(?<!\w)p(\d+)(?!\w)', '(?<!\w)x(\d+)(?!\w)'}, ...
                      {'p{$1}', 'x($1)'});
    made.(expression) = str2func (["@(p, x) " text]);
  endif
  f = made.(expression);
endfunction
