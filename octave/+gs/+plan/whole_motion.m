## one = gs.plan.whole_motion (who, m, jet, planned, closed, t, guess)
## Coordinates, speeds and accelerations of all of M at T, the planned ones as the JET says, whose
## first column holds their values and whose others their derivatives (0 where it has none).

function one = whole_motion (who, m, jet, planned, closed, t, guess)
  one = zeros (m.sizes.nu, m.order + 1);
  one(:,1) = guess;
  one(planned,1:columns (jet)) = jet;
  if (closed)
    one = follow (who, m, t, guess, one, planned);
  elseif (m.sizes.nlam > 0)
    consistent (who, m, t, one);
  endif
endfunction

## a motion of all coordinates of a closed chain must fulfil its constraints
function consistent (who, m, t, one)
  [~, scaled, found] = gs.start.constraint_residuals (m, t, ...
      [one(:,1); one(:,2); zeros(m.sizes.nx - 2 * m.sizes.nu, 1)]);
  if (! all (abs (scaled) <= 1e-6))
    error ("gsmbp:start", ...
           ["%s: %s: expected a planned motion on the constraints, found at t = %.9g s " "%s"], ...
           who, m.name, t, m.module ("worst", scaled, found, 1e-6));
  endif
endfunction

## the loops closed along the straight way from the guess to the planned position, on one branch,
## then the whole motion there
function one = follow (who, m, t, guess, one, planned)
  target = one(planned,1);
  [q, info, done] = m.module ("close", m.cst, t, m.order, guess(:), planned(:), target);
  if (info == 0)
    here = one;
    here(:,1) = q;
    here(planned,1) = target;
    [one, ~, info] = m.clo (t, here);
  endif
  if (info != 0)
    place = sprintf (" %.6g", guess(planned) + done * (target - guess(planned)));
    error ("%s: %s: the loop cannot follow the motion at t = %.9g s: it does not close at%s (%s)",
           who, m.name, t, place, gs.text.info_meaning (m, "clo", info));
  endif
endfunction
