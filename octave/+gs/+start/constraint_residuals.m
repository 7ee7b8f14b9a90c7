## [names, scaled, found] = gs.start.constraint_residuals (m, t, x)
## How far the state X of the model M at the time T [s] is from its constraints: a
## row for each set of Euler parameters, each constraint on positions and the rate of each
## constraint.  FOUND: in the unit of the row; SCALED: relative to nominal magnitudes
## (host/start.h).  There are no rows of constraints where CON was not emitted.

function [names, scaled, found] = constraint_residuals (m, t, x)
  [scaled, found, names] = m.module ("residuals", m.cst, gs.model.parameter_values (m), t, x, ...
                                     m.nominal);
endfunction
