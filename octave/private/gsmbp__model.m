## gsmbp__model (who, m)
## An error of WHO unless M is a model of gsmbp_build.

function gsmbp__model (who, m)
  if (! (isstruct (m) && isscalar (m) && all (isfield (m, {"module", "sizes", "subroutines"}))))
    error ("%s: argument m: expected a model of gsmbp_build, found %s", who, gsmbp__shown (m));
  endif
endfunction
