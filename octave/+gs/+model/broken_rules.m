## reason = gs.model.broken_rules (m, table)
## For each row of TABLE, a struct with a column for each parameter that differs, the rule of the
## model M that its values break, in words; "" where they break none.

function reason = broken_rules (m, table)
  gs.model.need_checks (m);
  names = fieldnames (table);
  values = cellfun (@(name) double (table.(name)(:))', names, "UniformOutput", false);
  par = repmat (gs.model.parameter_values (m), 1, numel (values{1}));
  [~, place] = ismember (names, fieldnames (m.par));
  par(place,:) = vertcat (values{:});
  [reason, negative] = gs.model.checked_values (m, par, names);
  cellfun (@(text) warning ("gsmbp:negative", "%s: %s", m.name, text), negative);
endfunction
