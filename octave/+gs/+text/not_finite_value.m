## text = gs.text.not_finite_value (values)
## What a message adds where one of the VALUES that it shows is not a number: "" if all are.

function text = not_finite_value (values)
  text = "";
  if (any (isnan (values(:))))
    text = gs.text.refusal_text ("no_number");
  endif
endfunction
