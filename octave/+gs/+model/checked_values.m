## [reason, negative] = gs.model.checked_values (m, par, names)
## Check values of the parameters of the model M by the routine CHK of the scene.  PAR: a column
## for each set of values, in the order of m.par.  REASON: for each column the first rule that it
## breaks, in words, "" where it breaks none.  NEGATIVE: the rules of the parameters NAMES that call
## for a warning, each with the first column of which a value is negative, in words.

function [reason, negative] = checked_values (m, par, names)
  reason = repmat ({""}, columns (par), 1);
  negative = cell (1, 0);
  rules = gs.model.json_rows (m.json, "rules");
  if (isempty (rules) || ! any (strcmp (m.subroutines, "chk")))
    return;
  endif
  [R, k, info] = m.module ("chk", par, numel (rules));
  for j = find (info)
    reason{j} = broken (m, rules, par(:,j), k(j), info(j));
  endfor
  for i = find (cellfun (@(rule) strcmp (rule.rule, "rather_nonnegative"), rules))
    j = find (R(i,:) < 0, 1);
    if (! isempty (j) && any (ismember (cellstr (rules{i}.parameters), names)))
      negative{end+1} = sprintf ("%s is negative, it gives energy to the motion: %s", ...
                                 rules{i}.place, found (m, rules{i}, par(:,j)));
    endif
  endfor
endfunction

function text = broken (m, rules, par, k, info)
  if (k == 0)
    text = m.module ("meaning", "chk", info);
    return;
  endif
  text = rules{k}.broken;
  if (info == 2)
    text = gs.text.refusal_text ("not_real", rules{k}.place);
  endif
  text = sprintf ("%s; found: %s", text, found (m, rules{k}, par));
endfunction

## the parameters of a rule with their values
function text = found (m, rule, par)
  names = cellstr (rule.parameters)(:)';
  [~, place] = ismember (names, fieldnames (m.par));
  pairs = cellfun (@(name, value) sprintf ("%s = %g", name, value), names, ...
                   num2cell (par(place)(:)'), "UniformOutput", false);
  text = strjoin (pairs, ", ");
endfunction
