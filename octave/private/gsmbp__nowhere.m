## text = gsmbp__nowhere (values)
## What a message adds where one of the VALUES that it shows is not a number: "" if all are.

function text = gsmbp__nowhere (values)
  text = "";
  if (any (isnan (values(:))))
    text = [" (no number: an element has no direction there, as a disc that lies flat on its " ...
            "plane or a cylinder or spring between two points that coincide)"];
  endif
endfunction
