## gsmbp__run (who, command)
## Runs a shell command; an error of WHO shows the command and what it wrote.

function gsmbp__run (who, command)
  [status, text] = system (["exec 2>&1; " command]);
  if (status != 0)
    error ("%s: this command failed (status %d)\n%s\n%s", who, status, command, text);
  endif
endfunction
