## value = gsmbp__value (m, row, x)
## The expression ROW.value of the JSON in the parameters p1, p2, ... named by
## ROW.parameters, with the values m.par, and in states x1, x2, ..., with the values X.

function value = gsmbp__value (m, row, x)
  p = cell (1, 0);
  if (! isempty (row.parameters))
    names = cellstr (row.parameters);
    for k = 1:numel (names)
      p{k} = m.par.(names{k});
    endfor
  endif
  f = function_of (row.value, numel (p), numel (x));
  value = double (f (p{:}, num2cell (x(:)'){:}));
endfunction

## the expression as a function; to make one takes much longer than to call it
function f = function_of (expression, np, nx)
  persistent made = struct ();
  key = sprintf ("%d %d %s", np, nx, expression);
  if (! isfield (made, key))
    if (numfields (made) >= 2000)
      made = struct ();
    endif
    letters = [numbered("p", np), numbered("x", nx)];
    made.(key) = str2func (sprintf ("@(%s) %s", strjoin (letters, ", "), expression));
  endif
  f = made.(key);
endfunction

function names = numbered (letter, n)
  names = arrayfun (@(k) sprintf ("%s%d", letter, k), 1:n, "UniformOutput", false);
endfunction
