## cases = gs.optimize.read_cases (who, m, given)
## The load cases of a design, a struct array: kind, name, args (the arguments in front), options
## (of the function that is called), target (a struct by names: what they should be), band (of the
## settling time).  GIVEN: a cell array of lists {kind, arguments, ..., option, value, ...}, or one
## such list.

function cases = read_cases (who, m, given)
  cases = struct ("kind", {}, "name", {}, "args", {}, "options", {}, "target", {}, "band", {});
  if (isempty (given))
    return;
  elseif (! iscell (given))
    error (["%s: argument cases: expected a list {kind, arguments, ...} or a list of such, " ...
            "found %s"], who, gs.text.shown_value (given));
  elseif (ischar (given{1}))
    given = {given};
  endif
  for k = 1:numel (given)
    cases(k) = one (who, m, k, given{k});
  endfor
  if (numel (unique ({cases.name})) < numel (cases))
    error ("%s: argument cases: two have the same name: %s", who, strjoin ({cases.name}, ", "));
  endif
endfunction

## number of arguments in front of the options
function c = one (who, m, k, list)
  known = {"run", 2, "times, start"; "inverse", 2, "motion, times"; "rest", 2, "states, inputs"
           "positions", 2, "names, values"; "loop", 1, "controller"};
  what = sprintf ("argument cases: case %d", k);
  if (! (iscell (list) && ! isempty (list) && ischar (list{1})))
    error ("%s: %s: expected a list {kind, arguments, ...}, found %s", who, what, ...
           gs.text.shown_value (list));
  endif
  row = find (strcmp (known(:,1), list{1}));
  if (isempty (row))
    error ("%s: %s: unknown kind %s", who, what, gs.text.nearest_word (list{1}, known(:,1)'));
  elseif (numel (list) < 1 + known{row,2})
    error ("%s: %s: %s: expected %s, found %d arguments", who, what, list{1}, known{row,3}, ...
           numel (list) - 1);
  endif
  c = struct ("kind", list{1}, "name", sprintf ("case%d", k), "args", ...
              {list(1 + (1:known{row,2}))}, "options", {list(2+known{row,2}:end)}, ...
              "target", struct (), "band", 0.02);
  for own = {"name", "target", "band"}
    c = taken (who, what, c, own{1});
  endfor
  if (! isvarname (c.name))
    error ("%s: %s: expected a name of letters and digits, found %s", who, what, ...
           gs.text.shown_value (c.name));
  endif
  gs.given.check_kind (who, [what ": band"], c.band, "positive");
  if (! (isstruct (c.target) && isscalar (c.target)))
    error ("%s: %s: target: expected a struct by names, found %s", who, what, ...
           gs.text.shown_value (c.target));
  endif
  if (strcmp (c.kind, "positions"))
    c = of_positions (who, what, m, c);
  endif
endfunction

## an option of the case itself
function c = taken (who, what, c, name)
  names = c.options(1:2:end);
  k = find (cellfun (@(n) ischar (n) && strcmp (n, name), names));
  if (! isempty (k))
    if (numel (c.options) < 2 * k(1))
      error ("%s: %s: option \"%s\" has no value", who, what, name);
    endif
    c.(name) = c.options{2*k(1)};
    c.options(2*k(1)-1:2*k(1)) = [];
  endif
endfunction

function c = of_positions (who, what, m, c)
  names = cellstr (c.args{1});
  k = find (! ismember (names, m.coordinates), 1);
  if (! isempty (k))
    error ("%s: %s: unknown coordinate %s", who, what, ...
           gs.text.nearest_word (names{k}, m.coordinates));
  endif
  table = {"guess", m.initial(1:m.sizes.nq), "any"};
  gs.given.call_options (who, table, c.options);
endfunction
