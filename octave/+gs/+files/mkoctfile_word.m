## text = gs.files.mkoctfile_word (word)
## Return the compiler or flags that `mkoctfile -p WORD` prints. Octave starts mkoctfile once in a
## session for each value of the variable WORD in the environment, which replaces its own.

function text = mkoctfile_word (word)
  persistent known = struct ();
  key = [word "=" getenv(word)];
  if (! isfield (known, key))
    known.(key) = strtrim (mkoctfile ("-p", word));
  endif
  text = known.(key);
endfunction
