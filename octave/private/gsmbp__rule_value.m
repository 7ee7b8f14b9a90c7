## v = gsmbp__rule_value (expression, p)
## An expression of a rule in p1, p2, ..., whose values are the cell array P: numbers, or columns of
## them (then a column).

function v = gsmbp__rule_value (expression, p)
  letters = strjoin (arrayfun (@(k) sprintf ("p%d", k), 1:numel (p), "UniformOutput", false), ", ");
  each = regexprep (expression, '([*/^])', '.$1');
  v = str2func (sprintf ("@(%s) %s", letters, each)) (p{:});
endfunction
