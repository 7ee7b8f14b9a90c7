## x = gs.start.consistent_start (who, m, t, x, wanted)
## The state X of the model M at the time T [s] as every calculation takes it: on
## the constraints, with Euler parameters of length one (host/start.h).  WANTED: "check", an error
## of WHO that names rows and residuals where one is above 1e-6 (scaled by m.nominal), or
## a margin of a device that is passed; "project", moved onto the constraints (subroutine PRJ) from
## wherever it is.

function x = consistent_start (who, m, t, x, wanted)
  x = gs.given.given_vector (who, "x", x, m.sizes.nx, sprintf (" (the states of %s)", m.name), ...
                             m.states);
  [x, start, text] = m.module ("start", m.cst, gs.model.parameter_values (m), t, x, m.nominal, ...
                               strcmp (wanted, "check"));
  if (start.verdict != 0)
    gs.start.refuse_start (who, m, "x", start, text);
  endif
endfunction
