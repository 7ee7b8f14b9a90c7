## value = gsmbp__value (m, row, x)
## The expression ROW.value of the JSON in the parameters p1, p2, ... named by
## ROW.parameters, with the values m.par, and in states x1, x2, ..., with the values X.

function value = gsmbp__value (m, row, x)
  p = cell (1, 0);
  if (! isempty (row.parameters))
    p = cellfun (@(name) m.par.(name), cellstr (row.parameters)(:)', "UniformOutput", false);
  endif
  letters = [numbered("p", numel (p)), numbered("x", numel (x))];
  f = str2func (sprintf ("@(%s) %s", strjoin (letters, ", "), row.value));
  value = double (f (p{:}, num2cell (x(:)'){:}));
endfunction

function names = numbered (letter, n)
  names = arrayfun (@(k) sprintf ("%s%d", letter, k), 1:n, "UniformOutput", false);
endfunction
