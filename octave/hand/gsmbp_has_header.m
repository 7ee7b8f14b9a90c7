## yes = gsmbp_has_header (FILE): whether the C compiler finds what the header FILE, which may be
## one of share/, includes; for tests.

function yes = gsmbp_has_header (file)
  here = fileparts (which ("gsmbp_build"));
  share = fullfile (here, "share");   # in the Octave package
  if (! isfolder (share))
    share = fullfile (fileparts (here), "share");
  endif
  if (! exist (file, "file"))
    file = fullfile (share, file);
  endif
  yes = system (sprintf ("sh '%s' '%s' %s >/dev/null", fullfile (share, "make", "find_header"), ...
                         file, strtrim (mkoctfile ("-p", "CC")))) == 0;
endfunction
