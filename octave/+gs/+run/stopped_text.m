## text = gs.run.stopped_text (word)
## What ended something from outside in words, of those of gs.run.stopped_word.

function text = stopped_text (word)
  text = {"interrupted by Ctrl-C", "ended by option timeout"}{1 + strcmp(word, "timeout")};
endfunction
