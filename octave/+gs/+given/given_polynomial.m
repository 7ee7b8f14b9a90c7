## pp = gs.given.given_polynomial (who, pp, n, what)
## An error of WHO unless PP is a piecewise polynomial, of N components where N
## is given (WHAT names them).

function pp = given_polynomial (who, pp, n, what)
  if (! (isstruct (pp) && isscalar (pp) && isfield (pp, "form") && strcmp (pp.form, "pp")))
    error ("%s: expected a piecewise polynomial (gsmbp_plan, mkpp), found a %s", who, class (pp));
  endif
  if (nargin > 2 && prod (pp.dim) != n)
    error ("%s: %s: expected %d components, found %d", who, what, n, prod (pp.dim));
  endif
endfunction
