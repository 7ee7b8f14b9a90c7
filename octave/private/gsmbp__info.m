## text = gsmbp__info (m, name, info)
## What the error indicator INFO of the subroutine NAME of the model M means, with
## its number: the sentences stand in glue/gsmbp_module.cc.

function text = gsmbp__info (m, name, info)
  text = sprintf ("%s: INFO = %d: %s", upper (name), info, m.module ("meaning", name, info));
endfunction
