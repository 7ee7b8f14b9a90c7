## gsmbp__put_in_place (who, new, file)
## The file NEW, which was made, under its name FILE, with its sum beside it (gsmbp__older).

function gsmbp__put_in_place (who, new, file)
  gsmbp__write (who, [file ".md5"], [hash("md5", fileread (new)) "\n"]);
  [failed, reason] = rename (new, file);
  if (failed)
    error ("%s: cannot write %s: %s", who, file, reason);
  endif
endfunction
