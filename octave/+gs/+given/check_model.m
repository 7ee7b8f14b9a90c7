## gs.given.check_model (who, m)
## An error of WHO unless M is a model of gsmbp_build.

function check_model (who, m)
  if (! (isstruct (m) && isscalar (m) && all (isfield (m, {"module", "sizes", "subroutines"}))))
    error ("%s: argument m: expected a model of gsmbp_build, found %s", who, ...
           gs.text.shown_value (m));
  endif
endfunction
