## options = gs.given.call_options (who, table, pairs)
## The options of the function WHO, a struct.  TABLE: a row {name, default, kind} for each
## (kind: as of gs.given.check_kind); PAIRS: what the user gave, names and values in turn, or the
## fields of one struct.  A name that is unknown or given twice and a value that is not of
## its kind are errors.  What is empty by default may be given empty.

function options = call_options (who, table, pairs)
  known = table(:,1)';
  options = cell2struct (table(:,2), known, 1);
  [names, values] = gs.given.name_value_pairs (who, "option", pairs);
  for i = 1:numel (names)
    k = find (strcmp (names{i}, known));
    if (isempty (k))
      error ("%s: unknown option %s", who, gs.text.nearest_word (names{i}, sort (known)));
    endif
    default = table{k,2};
    left_out = isempty (values{i}) && isempty (default) ...
               && (isequal (values{i}, []) || strcmp (class (values{i}), class (default)));
    if (! left_out)
      gs.given.check_kind (who, ["option " names{i}], values{i}, table{k,3});
    endif
    options.(names{i}) = values{i};
  endfor
endfunction
