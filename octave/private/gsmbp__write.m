## gsmbp__write (who, file, text)
## The file with that text, whole or not at all: written beside, looked at, renamed.
## What was there before stays if that fails, and it is an error of WHO.  The folder
## is made if it does not exist.

function gsmbp__write (who, file, text)
  gsmbp__folder (who, fileparts (file));
  new = sprintf ("%s.%d", file, getpid ());
  guard = onCleanup (@() gsmbp__discard (new));
  [f, reason] = fopen (new, "w");
  if (f < 0)
    error ("%s: cannot write %s: %s", who, file, reason);
  endif
  fputs (f, text);
  fclose (f);
  ## neither says reliably that the disk is full
  there = stat (new);
  if (isempty (there) || there.size != numel (text))
    error (["%s: cannot write %s: %d of %d bytes were written (is the disk full?); " ...
            "what was there before is as it was"], who, file, size_of (there), numel (text));
  endif
  [failed, reason] = rename (new, file);
  if (failed)
    error ("%s: cannot write %s: %s", who, file, reason);
  endif
endfunction

function n = size_of (there)
  n = 0;
  if (! isempty (there))
    n = there.size;
  endif
endfunction
