## x = gs.linear.follow_rest (m, t, x, q, u)
## The state X of the model M with what follows, by the constraints, from its coordinates Q and
## speeds U.

function x = follow_rest (m, t, x, q, u)
  d = m.sizes;
  if (d.nlam == 0 && d.nq == d.nu)
    return;
  endif
  own = [setdiff(1:d.nq, q), d.nq + setdiff(1:d.nu, u)];
  p = struct ("m", m, "t", t, "x", x, "v", zeros (d.nv, 1), "own", own, "inputs", [], ...
              "rows", [], "fixed", [], "size", m.nominal(own)(:), "steady", true);
  x(own) = gs.linear.rest_newton (p, x(own)(:));
endfunction
