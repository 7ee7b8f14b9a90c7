## text = gs.text.fortran_number (x)
## The number X as a constant of DOUBLE PRECISION, with as few digits as give it again.

function text = fortran_number (x)
  text = strrep (gs.text.all_digits (x), "e", "D");
  if (! any (text == "D"))
    text = [text "D0"];
  endif
  if (! any (text == "."))
    text = regexprep (text, "D", ".0D");
  endif
endfunction
