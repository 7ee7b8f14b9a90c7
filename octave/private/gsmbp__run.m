## gsmbp__run (who, command)
## Runs a shell command; an error of WHO shows the command and the beginning of what
## it wrote.

function gsmbp__run (who, command)
  [status, text] = system (["exec 2>&1; " command]);
  if (status != 0)
    full = "";
    words = 'No space left|File size limit|File too large';
    if (status == 153 || ! isempty (regexp (text, words, "once")))
      full = ", the disk is full";
    endif
    lines = strsplit (text, "\n");
    if (numel (lines) > 25)
      lines = [lines(1:25), {sprintf("... and %d more lines", numel (lines) - 25)}];
    endif
    error ("%s: this command failed (status %d%s)\n%s\n%s", who, status, full, command, ...
           strjoin (lines, "\n"));
  endif
endfunction
