## text = gs.text.all_digits (x)
## The number X with as few digits as give it again.

function text = all_digits (x)
  for n = 15:17
    text = sprintf ("%.*g", n, x);
    if (str2double (text) == x)
      return;
    endif
  endfor
endfunction
