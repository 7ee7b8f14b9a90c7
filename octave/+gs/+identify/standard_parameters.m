## s = gs.identify.standard_parameters (m)
## The standard parameters of the model M (ten of each link, frictions, rotors): names, and a handle
## s.at from the values of the parameters of M (a column, in the order of m.par) to [K, nominal],
## with base parameters = K * standard parameters and their values; s.K and s.nominal at the values
## of M.

function s = standard_parameters (m)
  list = gs.model.json_rows (m.json, "standard_parameters");
  base = gs.model.json_rows (m.json, "base_parameters");
  if (isempty (list))
    error ("%s: the JSON has no standard parameters: derive it again with this version", m.name);
  endif
  s.names = cellfun (@(r) r.name, list, "UniformOutput", false)';
  words = fieldnames (m.par);
  values = cellfun (@(r) in_one (r, words), list, "UniformOutput", false);
  [factors, place] = deal ({}, zeros (0, 2));
  for k = 1:numel (base)
    for row = gs.model.json_rows (base{k}, "standard")
      factors{end+1} = in_one (row{1}, words);
      place(end+1,:) = [k, find(strcmp (s.names, row{1}.name))];
    endfor
  endfor
  size_of = [numel(base), numel(list)];
  value_at = str2func (["@(p) [" strjoin(values, ";") "]"]);
  factor_at = str2func (["@(p) [" strjoin(factors, ";") "]"]);
  s.at = @(p) deal (accumarray (place, factor_at (p), size_of), value_at (p));
  [s.K, s.nominal] = s.at (cell2mat (struct2cell (m.par)));
endfunction

## the expression of a row in p(1), p(2), ..., the parameters WORDS
function text = in_one (row, words)
  text = strrep (["(" row.value ")"], " ", "");
  if (isempty (row.parameters))
    return;
  endif
  list = cellstr (row.parameters);
  for k = numel (list):-1:1
    text = regexprep (text, sprintf ("(?<!\\w)p%d(?!\\w)", k), ...
                      sprintf ("P(%d)", find (strcmp (words, list{k}))));
  endfor
  text = strrep (text, "P(", "p(");
endfunction
