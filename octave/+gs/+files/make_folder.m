## gs.files.make_folder (who, folder)
## Makes a folder that does not exist; an error of WHO if that fails.

function make_folder (who, folder)
  if (! isempty (folder) && ! exist (folder, "dir"))
    [ok, reason] = mkdir (folder);
    if (! ok)
      error ("%s: cannot make the folder %s: %s", who, folder, reason);
    endif
  endif
endfunction
