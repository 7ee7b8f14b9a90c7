## made = gs.files.build_once (who, target, flags, sources, make)
## made = gs.files.build_once (who, target, flags, sources, make, compiler)
## The file TARGET, made where it is missing, is not what was left there, or was made with other
## FLAGS or of other contents of the SOURCES (a cell array of names): a sum of them stands beside
## it.  MAKE (place) makes it in an empty folder and gives its name there.  Builds in one folder
## wait for each other, and what killed ones left there is swept.  MADE: whether it was made here.
## With COMPILER, a command with options, a copy is kept in the user's cache folder
## (gs.files.from_cache).

function made = build_once (who, target, flags, sources, make, compiler)
  made = ! gs.files.is_built (target, flags, sources);
  if (! made)
    return;
  endif
  folder = fileparts (target);
  gs.files.make_folder (who, folder);
  lock = gs.files.lock_folder (who, folder);
  [ready, key] = gs.files.is_built (target, flags, sources);   # by who had the lock
  made = ! ready;
  if (ready)
    return;
  endif
  cellfun (@remove, glob (fullfile (folder, ".new-*")));
  place = tempname (folder, ".new-");   # not of rand, which is the user's
  gs.files.make_folder (who, place);
  if (nargin > 5)
    make = @(place) gs.files.from_cache (who, target, compiler, key, make, place);
  endif
  unwind_protect
    new = fullfile (place, make (place));
    gs.files.new_beside (who, target);
    gs.files.write_text (who, [target ".md5"], [hash("md5", fileread (new)) " " key "\n"]);
    gs.files.rename_new (who, new, target);
  unwind_protect_cleanup
    remove (place);
  end_unwind_protect
endfunction

function remove (place)
  confirm_recursive_rmdir (false, "local");
  rmdir (place, "s");
endfunction
