## gs.text.tell_progress (template, values, ...)
## A line on the terminal that the next one overwrites, "" clears it; nothing where the errors of
## this session do not go to a terminal.

function tell_progress (varargin)
  if (gs.text.is_terminal ())
    fprintf (stderr, "\r%s\033[K", sprintf (varargin{:}));
    fflush (stderr);
  endif
endfunction
