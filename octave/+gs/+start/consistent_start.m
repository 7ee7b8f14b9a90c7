## [x, start] = gs.start.consistent_start (who, m, t, x, wanted, modes)
## The state X of the model M at the time T [s] as every calculation takes it: on
## the constraints, with Euler parameters of length one (host/start.h).  WANTED: "check", an error
## of WHO that names rows and residuals where one is above 1e-6 (scaled by m.nominal), or
## a margin of a device that is passed; "project", moved onto the constraints (subroutine PRJ) from
## wherever it is.  With the argument MODES (those of ports, [] if they are found) stops that are
## passed are an error, too.  START: a struct, see the help of gsmbp_simulate.

function [x, start] = consistent_start (who, m, t, x, wanted, modes)
  argument = {"x", "x0"}{1 + any(strcmp (who, {"gsmbp_simulate", "gsmbp_ensemble", ...
                                                "gsmbp_sweep", "gsmbp_workprecision"}))};
  x = gs.given.given_vector (who, argument, x, m.sizes.nx, sprintf (" (the states of %s)", ...
                                                                    m.name), m.states);
  stops = nargin > 5;
  if (! stops || ! isnumeric (modes) || any (! ismember (modes(:), [-1, 0, 1])))
    modes = [];   # what cannot be is refused with the plan of the run
  endif
  [x, verdict, text, residual, row, moved, k] = ...
      m.module ("start", m.cst, gs.model.parameter_values (m), t, x, m.nominal, strcmp (wanted, ...
          "check"), stops, double (modes));
  refuse (who, m, argument, verdict, text, k);
  start = struct ("residual", residual, "row", row, "moved", moved, "state", "");
  if (k > 0)
    start.state = m.states{k};
  endif
endfunction

## the message of C and the way out in Octave
function refuse (who, m, argument, verdict, text, k)
  [word, remedy] = gs.start.verdict_words (verdict);
  if (strcmp (word, "angle"))
    error ("%s: argument %s(%d), %s: %s", who, argument, k, m.coordinates{k}, text);
  elseif (! isempty (remedy))
    error ("gsmbp:start", "%s: %s: %s%s", who, m.name, text, remedy);
  elseif (verdict != 0)
    error ("%s: %s: %s", who, m.name, text);
  endif
endfunction
