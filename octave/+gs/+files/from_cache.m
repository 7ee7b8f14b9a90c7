## new = gs.files.from_cache (who, target, compiler, key, make, place)
## Make the file TARGET by MAKE (place) in the empty folder PLACE, or take it from the user's cache
## folder, where it is kept once it was made (share/make/cache).  NEW: its name in PLACE; COMPILER:
## the command with its options for a shell; KEY: a sum of all other things that it is made of.
## On a terminal a line reports that it is compiled, once for each function WHO in a session.

function new = from_cache (who, target, compiler, key, make, place)
  quote = @(file) ["'" strrep(file, "'", "'\\''") "'"];
  script = ["sh " quote(gs.files.own_place ("share", "make", "cache"))];
  [~, name, kind] = fileparts (target);
  folder = fullfile (place, "cached");
  new = fullfile (folder, [name kind]);
  [~, key] = system (sprintf ("echo %s | %s key %s", key, script, compiler));
  call = @(task) system (sprintf ("%s %s %s %s", script, task, strtrim (key), quote (folder)));
  taken = call ("take");
  if (taken == 3)
    error (["%s: cannot write %s: is the disk full, or a limit on the size of files reached " ...
            "(ulimit -f)?"], who, target);
  elseif (taken != 0 || isempty (stat (new)))
    tell (who, system ([script " folder >/dev/null"]) == 0);
    made = fullfile (place, make (place));
    gs.files.make_folder (who, folder);
    gs.files.rename_new (who, made, new);
    call ("add");
  endif
  new = fullfile ("cached", [name kind]);
endfunction

function tell (who, cached)
  persistent told = {};
  if (gs.text.is_terminal () && ! any (strcmp (told, who)))
    told{end+1} = who;
    once = {"folder (no cache folder)", "user"}{1 + cached};
    fprintf (stderr, "%s: compiling the run time, once for this %s\n", who, once);
  endif
endfunction
