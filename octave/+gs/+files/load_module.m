## gs.files.load_module (symbol, file, before)
## The module under its name; one that was linked anew takes the old one's place.

function load_module (symbol, file, before)
  now = stat (file);
  known = autoload ();
  if (! isempty (known) && any (strcmp ({known.function}, symbol)))
    if (! isempty (before) && before.mtime == now.mtime && before.ino == now.ino)
      return;
    endif
    autoload (symbol, file, "remove");
    clear ("-f", symbol);
  endif
  autoload (symbol, file);
endfunction
