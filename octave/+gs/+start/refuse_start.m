## gs.start.refuse_start (who, m, argument, start, text)
## The error of WHO for a start of the model M that is refused: TEXT of the engine and the way out
## in Octave.  START: a struct with verdict and state, its number; ARGUMENT: how the user calls it.

function refuse_start (who, m, argument, start, text)
  [word, remedy] = gs.start.verdict_words (start.verdict);
  if (strcmp (word, "angle"))
    error ("%s: argument %s(%d), %s: %s", who, argument, start.state, ...
           m.coordinates{start.state}, text);
  elseif (! isempty (remedy))
    error ("gsmbp:start", "%s: %s: %s%s", who, m.name, text, remedy);
  endif
  error ("%s: %s: %s", who, m.name, text);
endfunction
