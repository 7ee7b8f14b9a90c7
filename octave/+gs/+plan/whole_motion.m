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

## the loops closed along the straight way from the guess to the planned position,
## then the whole motion there.  A step of the way counts if the dependent coordinates
## move by the mean of their slopes at both ends, but for a tenth of the larger one:
## else Newton's method may have met another branch, and half the step is tried.
function one = follow (who, m, t, guess, one, planned)
  way = one(planned,1) - guess(planned);
  [at, done, step, info] = deal (guess, 1, 1, 0);
  if (any (way))   # else the guess is there
    for done = [0, 1e-3, 1e-2, 0.1, 1]   # the guess itself may be singular
      [at, slope, info] = closed_at (m, t, guess, planned, guess(planned) + done * way, way);
      if (info == 0)
        break;
      endif
    endfor
  endif
  while (info == 0 && done < 1)
    step = min (step, 1 - done);
    target = guess(planned) + way * (done + step);
    [next, after, missed] = closed_at (m, t, at + step * slope, planned, target, way);
    gap = abs (next - at - step * (slope + after) / 2);
    if (missed == 0 && all (gap <= 0.1 * step * max (abs (slope), abs (after)) + 1e-6))
      [at, slope, done, step] = deal (next, after, done + step, 2 * step);
    elseif (step > 1e-9)
      step /= 2;
    else
      info = max (missed, 2 * (missed == 0));
    endif
  endwhile
  if (info == 0)
    here = one;
    here(:,1) = at;
    here(planned,1) = one(planned,1);
    [one, res, info] = m.clo (t, here);
  endif
  if (info != 0)
    place = sprintf (" %.6g", guess(planned) + way * min (1, done + step));
    error ("%s: %s: the loop cannot follow the motion at t = %.9g s: it does not close at%s (%s)",
           who, m.name, t, place, gs.text.info_meaning (m, "clo", info));
  endif
endfunction

## coordinates Q closed near a guess with the planned ones at TARGET, and their slopes
## along WAY (their rates less those that they have while the planned ones rest)
function [q, slope, info] = closed_at (m, t, guess, planned, target, way)
  here = zeros (m.sizes.nu, m.order + 1);
  here(:,1) = guess;
  here(planned,1) = target;
  [rest, ~, info] = m.clo (t, here);
  slope = 0 * guess;
  q = rest(:,1);
  if (info == 0)
    rest(:,2:end) = 0;
    rest(planned,2) = way;
    [moving, ~, info] = m.clo (t, rest);
    rest(planned,2) = 0;
    slope = moving(:,2) - m.clo (t, rest)(:,2);
  endif
endfunction
