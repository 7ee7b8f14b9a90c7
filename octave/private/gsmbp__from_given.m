## p = gsmbp__from_given (p, x0)
## Many runs, laid out as P (gsmbp__run_setup): the start of each is moved onto its own constraints
## from X0 as it was given.

function p = gsmbp__from_given (p, x0)
  p.x0(:) = p.arguments{3}(:) = x0(:);
endfunction
