## text = gs.text.nearest_word (word, known)
## What an error says of a WORD that is none of the cell array KNOWN: itself, the one that is
## likely meant (two letters away at most), all of them.

function text = nearest_word (word, known)
  text = sprintf ("\"%s\"; known: %s", word, strjoin (known(:)', ", "));
  if (isempty (known))
    text = sprintf ("\"%s\"; there are none", word);
    return;
  endif
  away = cellfun (@(k) distance (tolower (word), tolower (k)), known);
  [least, k] = min (away);
  if (least <= min (2, numel (word) / 2))
    text = sprintf ("\"%s\", did you mean \"%s\"?; known: %s", word, known{k},
                    strjoin (known(:)', ", "));
  endif
endfunction

## letters to insert, delete or replace (Levenshtein)
function d = distance (a, b)
  row = 0:numel (b);
  for i = 1:numel (a)
    next = i;
    for j = 1:numel (b)
      next(j+1) = min ([row(j+1) + 1, next(j) + 1, row(j) + (a(i) != b(j))]);
    endfor
    row = next;
  endfor
  d = row(end);
endfunction
