## gsmbp__gnuplot (who, file, terminal, lines)
## Runs gnuplot on the cell array LINES; TERMINAL draws into FILE, which appears
## whole or not at all.  An error of WHO shows what gnuplot wrote.

function gsmbp__gnuplot (who, file, terminal, lines)
  [folder, ~, kind] = fileparts (file);
  if (! isempty (folder) && ! exist (folder, "dir"))
    mkdir (folder);
  endif
  new = sprintf ("%s-%d%s", file(1:end-numel (kind)), getpid (), kind);
  script = [tempname() ".gp"];
  guard = onCleanup (@() unlink (script));
  f = fopen (script, "w");
  if (f < 0)
    error ("%s: cannot write %s", who, script);
  endif
  fprintf (f, "%s\n", ["set terminal " terminal], ["set output " gsmbp__quoted(new)], lines{:});
  fclose (f);
  shell = @(text) ["'" strrep(text, "'", "'\\''") "'"];
  unwind_protect
    gsmbp__run (who, sprintf ("gnuplot %s && mv %s %s", shell (script), shell (new), shell (file)));
  unwind_protect_cleanup
    [~, ~] = unlink (new);   # there only if gnuplot failed
  end_unwind_protect
endfunction
