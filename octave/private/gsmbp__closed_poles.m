## poles = gsmbp__closed_poles (c)
## The poles of the plant of the controller C together with it.

function poles = gsmbp__closed_poles (c)
  poles = eig (gsmbp__closed (c));
endfunction
