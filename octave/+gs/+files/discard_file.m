## gs.files.discard_file (file)
## Removes a file if it is there: a part of one that could not be finished.

function discard_file (file)
  [~, ~] = unlink (file);
endfunction
