## text = gs.text.info_meaning (m, name, info)
## What the error indicator INFO of the subroutine NAME of the model M means, with
## its number, as the JSON says it.

function text = info_meaning (m, name, info)
  text = sprintf ("%s: INFO = %d: %s", upper (name), info, m.module ("meaning", name, info));
endfunction
