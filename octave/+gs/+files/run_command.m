## gs.files.run_command (who, command)
## gs.files.run_command (who, command, what, seconds)
## Runs a shell command; an error of WHO shows the command and the beginning of what
## it wrote.  With WHAT a terminal is told that it is done and how long it will take yet, where
## that is more than 3 SECONDS by an estimate.

function run_command (who, command, what, seconds)
  clock = "";
  if (nargin > 2 && seconds > 3 && gs.text.is_terminal ())
    clock = sprintf (["(n=%d; while sleep 1 && kill -0 $$; do n=$((n > 1 ? n - 1 : 1)); " ...
                      "printf '\\r%%s, about %%d s left\\033[K' '%s: %s' $n; " ...
                      "done) </dev/null >/dev/tty 2>/dev/null & t=$!; " ...
                      "trap 'kill $t; printf \"\\r\\033[K\" >/dev/tty' EXIT; " ...
                      "trap 'exit 130' INT TERM; "], ...
                     ceil (seconds), who, what);
  endif
  [status, text] = system (["exec 2>&1; " clock command]);
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
