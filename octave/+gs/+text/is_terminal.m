## yes = gs.text.is_terminal ()
## Whether the errors of this session go to a terminal: only there long work tells how far it is.

function yes = is_terminal ()
  persistent is = [];
  if (isempty (is))
    is = system ("test -t 2") == 0;
  endif
  yes = is;
endfunction
