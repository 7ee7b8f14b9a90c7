## x = gs.given.values_by_names (who, what, given, names)
## Return the values of GIVEN, a struct or a cell array {name, value, ...}, as a column in the order
## of NAMES, each of which must be given once.  WHO and WHAT begin the message of an error.

function x = values_by_names (who, what, given, names)
  if (isstruct (given) && isscalar (given))
    given = [fieldnames(given), struct2cell(given)]';
  endif
  if (! (iscell (given) && mod (numel (given), 2) == 0 && iscellstr (given(1:2:end))))
    error ("%s: %s: expected {name, value, ...} or a struct of numbers, found %s", who, what,
           gs.text.shown_value (given));
  endif
  [told, values] = deal (given(1:2:end), given(2:2:end));
  [known, place] = ismember (told, names);
  if (! all (known))
    error ("%s: %s: found unknown name %s", who, what,
           gs.text.nearest_word (told{find (! known, 1)}, names));
  endif
  count = accumarray (place(:), 1, [numel(names), 1]);
  k = find (count != 1, 1);
  if (! isempty (k))
    error ("%s: %s: expected %s once, found it %d times", who, what, names{k}, count(k));
  endif
  wrong = find (! cellfun (@(v) isnumeric (v) && isreal (v) && isscalar (v), values), 1);
  if (! isempty (wrong))
    error ("%s: %s: %s: expected a number, found %s", who, what, told{wrong},
           gs.text.shown_value (values{wrong}));
  endif
  x = zeros (numel (names), 1);
  x(place) = cellfun (@double, values);
endfunction
