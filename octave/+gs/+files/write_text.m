## gs.files.write_text (who, file, text)
## Write FILE with that text, complete or not at all: next to it, checked, renamed.
## What was there before stays if that fails, and it is an error of WHO.  The folder
## is made if it does not exist.

function write_text (who, file, text)
  new = gs.files.new_beside (who, file);
  guard = onCleanup (@() gs.files.discard_file (new));
  [f, reason] = fopen (new, "w");
  if (f < 0)
    error ("%s: cannot write %s: %s", who, file, reason);
  endif
  fputs (f, text);
  closed = fclose (f) == 0;
  ## a full disk is not always an error of these
  there = stat (new);
  if (! closed || isempty (there) || there.size != numel (text))
    error (["%s: cannot write %s: %d of %d bytes were written (is the disk full?); " ...
            "what was there before is as it was"], who, file, size_of (there), numel (text));
  endif
  gs.files.rename_new (who, new, file);
endfunction

function n = size_of (there)
  n = 0;
  if (! isempty (there))
    n = there.size;
  endif
endfunction
