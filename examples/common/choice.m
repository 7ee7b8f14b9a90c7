## choice (FILE, ARGUMENTS): prints the table of gsmbp_choose (scene, ARGUMENTS) for the scene of
## FILE in the folder of the example; Maxima's log in out/choice.log.

function choice (file, arguments)
  root = fullfile (pwd (), "..", "..");
  log = fullfile ("out", "choice.log");
  status = system (sprintf (["'%s/share/make/maxima' %s 'load(\"%s/gsmbp/gsmbp.mac\")$ " ...
                             "load(\"%s/%s\")$ " ...
                             "gsmbp_choose(scene, %s)$'"], root, log, root, pwd (), file, ...
                            arguments));
  if (status != 0)
    error ("choice: gsmbp_choose failed, see %s", log);
  endif
  text = fileread (log);
  puts (text(strfind (text, "device, variant"):strfind (text, "gs__exit") - 1));
endfunction
