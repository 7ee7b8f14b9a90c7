## gsmbp__discard (file)
## Removes a file if it is there: a part of one that could not be finished.

function gsmbp__discard (file)
  [~, ~] = unlink (file);
endfunction
