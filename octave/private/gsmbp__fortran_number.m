## text = gsmbp__fortran_number (x)
## The number X as a constant of DOUBLE PRECISION, with as few digits as give it again.

function text = gsmbp__fortran_number (x)
  text = strrep (gsmbp__digits (x), "e", "D");
  if (! any (text == "D"))
    text = [text "D0"];
  endif
  if (! any (text == "."))
    text = regexprep (text, "D", ".0D");
  endif
endfunction
