## reason = gsmbp__broken_rules (m, table)
## For each row of TABLE, a struct with a column for each parameter that differs, the rule of the
## model M that its values break, in words; "" where they break none.

function reason = gsmbp__broken_rules (m, table)
  names = fieldnames (table)';
  n = numel (table.(names{1}));
  reason = repmat ({""}, n, 1);
  for rule = gsmbp__rules (m)
    own = cellstr (rule{1}.parameters);
    if (! any (ismember (own, names)))
      continue;
    endif
    p = cellfun (@(name) column (m, table, name, n), own, "UniformOutput", false);
    v = cellfun (@(e) gsmbp__rule_value (e, p) .* ones (n, 1), cellstr (rule{1}.values)(:)', ...
                 "UniformOutput", false);
    v = [v{:}];
    for i = suspects (rule{1}.rule, v)'
      what = gsmbp__rule_failure (rule{1}.rule, v(i,:)');
      if (! isempty (what) && isempty (reason{i}))
        found = cellfun (@(name, x) sprintf ("%s = %g", name, x(i)), own(:)', p(:)', ...
                         "UniformOutput", false);
        reason{i} = sprintf ("%s %s; found: %s", rule{1}.place, what, strjoin (found, ", "));
      endif
    endfor
  endfor
endfunction

function x = column (m, table, name, n)
  x = m.par.(name) * ones (n, 1);
  if (isfield (table, name))
    x = double (table.(name)(:));
  endif
endfunction

## the rows that may break a rule: those of values that are fine by a look are none
function i = suspects (rule, v)
  fine = false (rows (v), 1);
  if (any (strcmp (rule, {"nonnegative", "positive", "nonzero", "rather_nonnegative"})))
    fine = all (v > 0 & isfinite (v), 2);
  endif
  i = find (! fine);
endfunction
