## rules = gsmbp__rules (m)
## The rules that the scene of the model M has for its values, a cell array of structs: place, rule,
## parameters, expressions in them.

function rules = gsmbp__rules (m)
  rules = cell (1, 0);
  if (isfield (m, "json") && isfield (m.json, "rules") && ! isempty (m.json.rules))
    rules = m.json.rules;
    if (isstruct (rules))
      rules = num2cell (rules);
    endif
    rules = rules(:)';
  endif
endfunction
