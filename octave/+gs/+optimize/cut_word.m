## word = gs.optimize.cut_word (err, o)
## What ended a part of a design from outside, by the error it left: "interrupted", "timeout"; ""
## where there is none (ERR is []), or where it is another.

function word = cut_word (err, o)
  word = "";
  if (! isempty (err) && strcmp (err.identifier, "gsmbp:stopped"))
    word = {"interrupted", "timeout"}{1 + (time () >= o.ends)};
  endif
endfunction
