## made = gsmbp__built (who, target, flags, sources, make)
## The file TARGET, made where it is missing, is not what was left there, or was made with other
## FLAGS or of other contents of the SOURCES (a cell array of names): a sum of them stands beside
## it.  MAKE (place) makes it in an empty folder and gives its name there.  Builds in one folder
## wait for each other, and what killed ones left there is swept.  MADE: whether it was made here.

function made = gsmbp__built (who, target, flags, sources, make)
  key = sum_of (flags, sources);
  made = ! is_there (target, key);
  if (! made)
    return;
  endif
  folder = fileparts (target);
  gsmbp__folder (who, folder);
  lock = gsmbp__lock (who, folder);
  made = ! is_there (target, key);   # by who had the lock
  if (! made)
    return;
  endif
  cellfun (@remove, glob (fullfile (folder, ".new-*")));
  place = fullfile (folder, sprintf (".new-%d-%d", getpid (), randi (1e9)));
  gsmbp__folder (who, place);
  unwind_protect
    new = fullfile (place, make (place));
    gsmbp__write (who, [target ".md5"], [hash("md5", fileread (new)) " " key "\n"]);
    [failed, reason] = rename (new, target);
    if (failed)
      error ("%s: cannot write %s: %s", who, target, reason);
    endif
  unwind_protect_cleanup
    remove (place);
  end_unwind_protect
endfunction

## times in whole seconds do not tell what was edited in the second of a build
function key = sum_of (flags, sources)
  sums = cellfun (@(file) hash ("md5", fileread (file)), sources, "UniformOutput", false);
  key = hash ("md5", sprintf ("%s\n", flags, sums{:}));
endfunction

## a module that is cut short would end Octave when it is loaded
function yes = is_there (target, key)
  said = [target ".md5"];
  yes = ! isempty (stat (target)) && ! isempty (stat (said)) ...
        && strcmp (fileread (said), [hash("md5", fileread (target)) " " key "\n"]);
endfunction

function remove (place)
  confirm_recursive_rmdir (false, "local");
  rmdir (place, "s");
endfunction
