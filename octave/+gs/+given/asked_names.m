## names = gs.given.asked_names (given)
## The names that an option was given, a word or a cell array of words, as a column; empty ones are
## none.

function names = asked_names (given)
  names = cellstr (given)(:);
  names = names(! cellfun (@isempty, names));
endfunction
