## [words, found] = gs.files.find_header (library)
## The WORDS by which Octave's C compiler finds what header_LIBRARY.h includes, "cvode", "ipopt" or
## "nlopt" (share/make/find_header), and whether it is installed.

function [words, found] = find_header (library)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  [status, words] = system (["sh " quote(gs.files.own_place ("share", "make", ...
                                                             "find_header")) " " ...
                             quote(gs.files.own_place ("share", "engine", "host", library, ...
                                                       ["header_" library ".h"])) " " ...
                             strtrim(mkoctfile ("-p", "CC"))]);
  found = status == 0;
  words = strtrim (words);
endfunction
