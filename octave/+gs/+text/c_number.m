## text = gs.text.c_number (x)
## The number X as a constant of double in C, with as few digits as give it again.

function text = c_number (x)
  if (isinf (x))
    text = {"HUGE_VAL", "-HUGE_VAL"}{1 + (x < 0)};
    return;
  endif
  text = gs.text.all_digits (x);
  if (! any (ismember (text, ".en")))
    text = [text ".0"];
  endif
endfunction
