## text = gsmbp__nowhere (values)
## What a message adds where one of the VALUES that it shows is not a number: "" if all are.

function text = gsmbp__nowhere (values)
  text = "";
  if (any (isnan (values(:))))
    text = gsmbp__refusal ("no_number");
  endif
endfunction
