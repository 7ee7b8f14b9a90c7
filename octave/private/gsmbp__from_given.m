## p = gsmbp__from_given (p, x0)
## Many runs, laid out as P (gsmbp__run_setup): where starts are moved onto constraints
## from wherever they are, each run's is moved from X0 as it was given, onto its own.

function p = gsmbp__from_given (p, x0)
  if (strcmp (p.o.start, "project"))
    p.x0(:) = p.arguments{3}(:) = x0(:);
  endif
endfunction
