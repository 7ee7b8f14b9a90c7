## gs.files.rename_new (who, new, file)
## The complete file NEW (gs.files.new_beside) takes the name FILE, which is followed if it is a
## symbolic link; an error of WHO if that fails.

function rename_new (who, new, file)
  target = canonicalize_file_name (file);
  if (isempty (target))
    target = file;
  endif
  [failed, reason] = rename (new, target);
  if (failed)
    error ("%s: cannot write %s: %s", who, file, reason);
  endif
endfunction
