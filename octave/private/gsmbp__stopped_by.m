## text = gsmbp__stopped_by (word)
## What ended something from outside in words, of those of gsmbp__stopped.

function text = gsmbp__stopped_by (word)
  text = {"interrupted by Ctrl-C", "ended by option timeout"}{1 + strcmp(word, "timeout")};
endfunction
