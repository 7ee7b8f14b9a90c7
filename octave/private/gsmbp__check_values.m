## gsmbp__check_values (m)
## Stops if the parameters m.par break a rule that the scene has for its values
## (m.json.rules: place, rule, parameters, expressions in them as p1, p2, ..., and for an
## inequality between parameters what is expected).

function gsmbp__check_values (m)
  for rule = gsmbp__rows (m.json, "rules")
    check (m, rule{1}, cellstr (rule{1}.values));
  endfor
endfunction

function check (m, rule, expressions)
  v = zeros (numel (expressions), 1);
  for k = 1:numel (expressions)
    rule.value = expressions{k};
    v(k) = gsmbp__value (m, rule, []);
  endfor
  what = gsmbp__rule_failure (rule, v);
  negative = isempty (what) && strcmp (rule.rule, "rather_nonnegative") && v < 0;
  if (isempty (what) && ! negative)
    return;
  endif
  pairs = cellfun (@(name) sprintf ("%s = %g", name, m.par.(name)), ...
                   cellstr (rule.parameters)(:)', "UniformOutput", false);
  pairs = strjoin (pairs, ", ");
  if (negative)
    warning ("gsmbp:negative", "gsmbp_set: %s: %s is negative, it gives energy to the motion: %s",
             m.name, rule.place, pairs);
  else
    error ("gsmbp_set: %s: %s; found: %s", m.name, what, pairs);
  endif
endfunction
