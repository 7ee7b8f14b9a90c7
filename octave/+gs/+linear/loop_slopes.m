## [X, dtau, dlam] = gs.linear.loop_slopes (who, m, t, motion, tau, lam, planned, Q, P)
## How a motion of a closed chain and its efforts change (ILP): MOTION, a column each of
## coordinates, speeds and accelerations, with the efforts TAU and multipliers LAM of INL.  Q: the
## changes of the coordinates PLANNED, of their speeds and accelerations, numel (planned) x 3 x n;
## P: of the parameters m.json.sensitivity, a column for each of the n changes.  X: nu x 3 x n; an
## error where the loops are singular.

function [X, dtau, dlam] = loop_slopes (who, m, t, motion, tau, lam, planned, Q, P)
  d = m.sizes;
  D = m.ilp (t, motion(:,1), motion(:,2), motion(:,3), zeros (d.nv, 1), tau(:), lam(:));
  [X, e, singular] = m.module ("loop slopes", planned(:), P, reshape (Q, numel (planned), []), D);
  if (singular)
    error ("%s: %s: no derivatives by the loops at t = %.9g s: the position is singular for %s", ...
           who, m.name, t, strjoin (m.coordinates(planned)(:)', ", "));
  endif
  dtau = e(1:d.nact,:);
  dlam = e(d.nact+1:end,:);
endfunction
