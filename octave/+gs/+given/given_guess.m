## x = gs.given.given_guess (who, m, name, x, rest)
## The argument X (called NAME) of WHO as all states of the model M: given are these, or the
## coordinates alone, which REST follows.

function x = given_guess (who, m, name, x, rest)
  d = m.sizes;
  what = sprintf (" (the states of %s, or its %d coordinates)", m.name, d.nq);
  if (isnumeric (x) && numel (x) == d.nq && d.nx != d.nq)
    x = [gs.given.given_vector(who, name, x, d.nq, what, m.coordinates); rest];
  endif
  x = gs.given.given_vector (who, name, x, d.nx, what, m.states);
endfunction
