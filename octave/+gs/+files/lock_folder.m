## guard = gs.files.lock_folder (who, folder)
## FOLDER is this session's alone until GUARD is cleared; who comes second waits.  A process of its
## own holds the lock (flock of util-linux) as long as its input is open: a session that is killed
## leaves none behind; what Ctrl-C has left running, and holds that input, does not keep it.
## Without flock nobody waits.

function guard = lock_folder (who, folder)
  file = strrep (fullfile (folder, "lock"), "'", "'\\''");
  hold = "exec flock -o '%s' sh -c 'echo locked; exec cat >/dev/null' 2>/dev/null";
  [in, out, pid] = popen2 ("sh", {"-c", sprintf(hold, file)});
  guard = onCleanup (@() release (in, out, pid));
  start = tic ();
  told = false;
  while (! ischar (fgets (out)))
    fclear (out);
    if (waitpid (pid, WNOHANG) != 0)
      return;
    endif
    if (! told && toc (start) > 1)
      told = true;
      gs.text.tell_progress ("%s: waits for another build in %s", who, folder);
    endif
    pause (0.02);
  endwhile
  if (told)
    gs.text.tell_progress ("");
  endif
endfunction

function release (in, out, pid)
  fclose (in);
  fclose (out);
  kill (pid, SIG ().TERM);
  waitpid (pid);
endfunction
