## gs.given.check_estimates (who, e)
## An error of WHO unless E is a result of gsmbp_identify or gsmbp_consistent.

function check_estimates (who, e)
  if (! (isstruct (e) && isscalar (e) && all (isfield (e, {"names", "p", "covariance", "kind", ...
                                                          "R", "z", "options"}))))
    error ("%s: argument e: expected a result of gsmbp_identify or gsmbp_consistent, found %s", ...
           who, gs.text.shown_value (e));
  endif
endfunction
