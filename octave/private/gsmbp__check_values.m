## gsmbp__check_values (m)
## Stops if the parameters m.par break a rule that the scene has for its values
## (m.json.rules: place, rule, parameters, and expressions in them as p1, p2, ...).

function gsmbp__check_values (m)
  if (! isfield (m, "json") || ! isfield (m.json, "rules") || isempty (m.json.rules))
    return;
  endif
  rules = m.json.rules;
  for i = 1:numel (rules)
    if (iscell (rules))
      rule = rules{i};
    else
      rule = rules(i);
    endif
    check (m, rule, cellstr (rule.parameters), cellstr (rule.values));
  endfor
endfunction

function check (m, rule, names, expressions)
  p = cellfun (@(name) m.par.(name), names, "UniformOutput", false);
  letters = strjoin (arrayfun (@(k) sprintf ("p%d", k), 1:numel (p), "UniformOutput", false), ", ");
  v = cellfun (@(e) str2func (sprintf ("@(%s) %s", letters, e)) (p{:}), expressions);
  what = failure (rule.rule, double (v(:)));
  negative = isempty (what) && strcmp (rule.rule, "rather_nonnegative") && v < 0;
  if (isempty (what) && ! negative)
    return;
  endif
  pairs = cellfun (@(name, x) sprintf ("%s = %g", name, x), names(:)', p(:)', ...
                   "UniformOutput", false);
  pairs = strjoin (pairs, ", ");
  if (negative)
    warning ("gsmbp:negative", "gsmbp_set: %s: %s is negative, it gives energy to the motion: %s",
             m.name, rule.place, pairs);
  else
    error ("gsmbp_set: %s: %s %s; found: %s", m.name, rule.place, what, pairs);
  endif
endfunction

## what is wrong with the values v under a rule, or ""
function text = failure (rule, v)
  text = "";
  if (strcmp (rule, "axis") && ! all (isfinite (v)))
    text = "must not be the zero vector";
  elseif (! isreal (v) || ! all (isfinite (v)))
    text = "must be real and finite";
  else
    switch (rule)
      case "nonnegative"
        text = unless (v >= 0, "must not be negative");
      case "positive"
        text = unless (v > 0, "must be above 0");
      case "nonzero"
        text = unless (v != 0, "must not be 0");
      case "fraction"
        text = unless (v > 0 && v <= 1, "must be above 0 and at most 1");
      case "axis"
        text = unless (any (abs (v) >= 1e-12), "must not be the zero vector");
      case "across"
        text = unless (abs (v(1:3)' * v(4:6)) < 1e-12, "must be across axis");
      case "inertia"
        text = unless (is_semidefinite (reshape (v, 3, 3)), "must have no negative eigenvalue");
      case "rotation"
        text = unless (is_rotation (reshape (v, 3, 3)),
                       "must be a rotation (R'R = 1, determinant 1)");
    endswitch
  endif
endfunction

function text = unless (holds, text)
  if (holds)
    text = "";
  endif
endfunction

function yes = is_semidefinite (I)
  yes = min (eig ((I + I') / 2)) >= -1e-13 * max (abs (I(:)));
endfunction

function yes = is_rotation (R)
  yes = all (all (abs (R' * R - eye (3)) < 1e-12)) && det (R) > 0;
endfunction
