## reason = gsmbp__broken_rules (m, table)
## For each row of TABLE, a struct with a column for each parameter that differs, the rule of the
## model M that its values break, in words; "" where they break none.

function reason = gsmbp__broken_rules (m, table)
  names = fieldnames (table)';
  n = numel (table.(names{1}));
  reason = repmat ({""}, n, 1);
  for name = names
    m.par.(name{1}) = double (table.(name{1})(:));
  endfor
  for rule = gsmbp__rows (m.json, "rules")
    if (! any (cellfun (@(name) any (strcmp (name, rule{1}.parameters)), names)))
      continue;
    endif
    v = cellfun (@(e) values (m, rule{1}, e, n), cellstr (rule{1}.values)(:)', ...
                 "UniformOutput", false);
    v = [v{:}];
    for i = suspects (rule{1}.rule, v)'
      what = gsmbp__rule_failure (rule{1}, v(i,:)');
      if (! isempty (what) && isempty (reason{i}))
        reason{i} = sprintf ("%s; found: %s", what, found (m, rule{1}, i));
      endif
    endfor
    i = find (any (v < 0, 2), 1);
    if (strcmp (rule{1}.rule, "rather_nonnegative") && ! isempty (i))
      warning ("gsmbp:negative", "%s: %s is negative, it gives energy to the motion: %s", ...
               m.name, rule{1}.place, found (m, rule{1}, i));
    endif
  endfor
endfunction

## an expression in the columns of the parameters
function v = values (m, rule, expression, n)
  rule.value = regexprep (expression, '(?<!\.)([*/^])', '.$1');
  v = gsmbp__value (m, rule, []) .* ones (n, 1);
endfunction

function text = found (m, rule, i)
  pairs = cellfun (@(name) sprintf ("%s = %g", name, m.par.(name)(min (i, end))), ...
                   cellstr (rule.parameters)(:)', "UniformOutput", false);
  text = strjoin (pairs, ", ");
endfunction

## the rows that may break a rule: those of values that are fine by a look are none
function i = suspects (rule, v)
  fine = false (rows (v), 1);
  switch (rule)
    case {"nonnegative", "positive", "nonzero", "rather_nonnegative"}
      fine = all (v > 0 & isfinite (v), 2);
    case "fraction"
      fine = all (v > 0 & v <= 1, 2);
    case "inertia"
      fine = are_inertias (v);
  endswitch
  i = find (! fine);
endfunction

## matrices by rows that are diagonal without a negative number, or clearly positive definite, by
## their leading minors
function fine = are_inertias (v)
  beside = max (abs (v(:,[2, 3, 4, 6, 7, 8])), [], 2);
  size_ = max (abs (v), [], 2);
  [xy, xz, yz] = deal ((v(:,2) + v(:,4)) / 2, (v(:,3) + v(:,7)) / 2, (v(:,6) + v(:,8)) / 2);
  second = v(:,1) .* v(:,5) - xy .^ 2;
  third = v(:,9) .* second - v(:,1) .* yz .^ 2 - v(:,5) .* xz .^ 2 + 2 * xy .* xz .* yz;
  fine = all (isfinite (v), 2) & ((beside == 0 & all (v(:,[1, 5, 9]) >= 0, 2))
         | (v(:,1) > 1e-9 * size_ & second > 1e-9 * size_ .^ 2 & third > 1e-9 * size_ .^ 3));
endfunction
