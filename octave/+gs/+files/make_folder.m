## gs.files.make_folder (who, folder)
## Makes a folder that does not exist; an error of WHO if that fails.  Another process may make it,
## or one above it, at the same time.

function make_folder (who, folder)
  if (! isempty (folder) && ! exist (folder, "dir"))
    turns = numel (strsplit (folder, "/"));   # each folder above may be made meanwhile
    do
      [ok, reason] = mkdir (folder);
      turns--;
    until (ok || turns < 0)
    if (! ok)
      error ("%s: cannot make the folder %s: %s", who, folder, reason);
    endif
  endif
endfunction
