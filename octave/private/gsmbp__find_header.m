## [words, found] = gsmbp__find_header (library)
## The WORDS by which Octave's C compiler finds what glue/header_LIBRARY.h includes, "cvode" or
## "ipopt" (glue/find_header), and whether it is installed.

function [words, found] = gsmbp__find_header (library)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  glue = @(file) quote (gsmbp__place ("octave", "glue", file));
  [status, words] = system (["sh " glue("find_header") " " glue(["header_" library ".h"]) " " ...
                             strtrim(mkoctfile ("-p", "CC"))]);
  found = status == 0;
  words = strtrim (words);
endfunction
