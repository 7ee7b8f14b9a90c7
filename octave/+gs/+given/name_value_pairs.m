## [names, values] = gs.given.name_value_pairs (who, what, pairs)
## Names and values of the cell array PAIRS, in turn, or of the fields of the one struct that it
## holds; an error of WHO where they are no pairs, or where a name is given twice.  WHAT is
## named: "option", "parameter".

function [names, values] = name_value_pairs (who, what, pairs)
  if (numel (pairs) == 1 && isstruct (pairs{1}))
    given = pairs{1};
    if (! isscalar (given))
      error ("%s: expected one struct of %ss, found %s", who, what, gs.text.shown_value (given));
    endif
    pairs = [fieldnames(given), struct2cell(given)]'(:)';
  endif
  names = pairs(1:2:end);
  values = pairs(2:2:end);
  for i = 1:numel (names)
    name = names{i};
    if (! (ischar (name) && rows (name) == 1))
      error ("%s: expected the name of %s %s, found %s", who, article (what), what, ...
             gs.text.shown_value (name));
    elseif (i > numel (values))
      error ("%s: %s \"%s\" has no value; expected pairs of a name and a value", who, what, name);
    elseif (any (strcmp (name, names(1:i-1))))
      error ("%s: %s \"%s\" is given twice", who, what, name);
    endif
  endfor
endfunction

function word = article (what)
  word = {"a", "an"}{1 + any(what(1) == "aeio")};
endfunction
