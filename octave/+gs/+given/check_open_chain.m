## gs.given.check_open_chain (who, m)
## An error of WHO unless M is an open chain whose speeds are the rates of its coordinates, derived
## with its regressor.

function check_open_chain (who, m)
  gs.given.check_moving (who, m);
  if (m.sizes.nlam > 0 || m.sizes.nq != m.sizes.nu)
    error (["%s: %s has loops or Euler parameters: expected an open chain whose speeds are the " ...
            "rates of its coordinates"], who, m.name);
  endif
endfunction
