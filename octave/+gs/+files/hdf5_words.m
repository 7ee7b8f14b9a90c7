## [words, links] = gs.files.hdf5_words (who)
## The options of the compiler and of the linker for the HDF5 library (Debian: libhdf5-dev, which
## octave-dev needs).

function [words, links] = hdf5_words (who)
  [failed, said] = system ("h5cc -show 2>/dev/null");
  places = regexp (said, '-[IL]\S+', "match");
  words = strjoin (places(strncmp (places, "-I", 2)), " ");
  links = strjoin ([places(strncmp (places, "-L", 2)), {"-lhdf5"}], " ");
  cc = strtrim (mkoctfile ("-p", "CC"));
  look = ["echo '#include <hdf5.h>' | " cc " " words " -E - >/dev/null 2>&1"];
  if (system (look) != 0)
    error ("%s: the HDF5 library is not installed (Debian: libhdf5-dev)", who);
  endif
endfunction
