## [rtol, atol] = gs.run.error_tolerances (who, m, rtol, atol, method)
## The tolerances of an integrator, RTOL a number, ATOL a column for the states of M
## (RTOL times m.nominal where it is empty), neither below what the precision of the
## build can keep: ten units of rounding (the error estimate of a step of dp853 rounds
## to about one), a hundred with cvode (its Newton iteration and the projection within
## it leave more), for ATOL of the usual size of each state.  Below that, steps are
## rejected for rounding errors, at any length.  What is below is raised, with a
## warning; rk4 has no tolerances.

function [rtol, atol] = error_tolerances (who, m, rtol, atol, method)
  fits = isnumeric (atol) && isreal (atol) && any (numel (atol) == [0, 1, m.sizes.nx]) ...
         && (isempty (atol) || isvector (atol));
  if (! (fits && all (atol(:) >= 0) && all (isfinite (atol(:)))))
    error ("%s: option atol: %s", who, ...
           gs.text.refusal_text ("atol", m.sizes.nx, gs.text.shown_value (atol)));
  endif
  rounding = struct ("double", eps, "quad", 2 ^ -112).(m.precision);
  least = 10 * rounding;
  if (any (strcmp (method, {"cvode", "auto"})))
    least = 100 * rounding;
  endif
  small = {};
  if (rtol < least)
    small{end+1} = sprintf ("rtol = %g", rtol);
    rtol = least;
  endif
  if (isempty (atol))
    atol = rtol * m.nominal;
  endif
  atol = double (atol(:)) .* ones (m.sizes.nx, 1);
  low = find (atol < least * m.nominal * (1 - 1e-9));
  if (! isempty (low))
    small{end+1} = sprintf ("atol = %g of %s", atol(low(1)), m.states{low(1)});
    atol(low) = least * m.nominal(low);
  endif
  if (! isempty (small) && ! strcmp (method, "rk4"))
    warning ("gsmbp:tolerance", "%s: %s: %s", who, m.name, ...
             gs.text.refusal_text ("low_tolerance", strjoin (small, ", "), m.precision, least));
  endif
endfunction
