## text = gsmbp__rule_failure (row, v)
## What is wrong with the values V (a column) under the ROW of m.json.rules, with its place; "" if
## nothing.

function text = gsmbp__rule_failure (row, v)
  text = broken (row.rule, v);
  if (isempty (text))
    return;
  elseif (isfield (row, "expected") && ! isempty (row.expected))
    text = sprintf ("%s: expected %s", row.place, row.expected);
  else
    text = sprintf ("%s %s", row.place, text);
  endif
endfunction

function text = broken (rule, v)
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
