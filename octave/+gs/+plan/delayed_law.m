## law = gs.plan.delayed_law (who, law, T, k)
## The law of coordinate K with a lower peak, so that it takes the time T; an error of WHO where
## the way is too short to lose so much time on it without a stop.

function law = delayed_law (who, law, T, k)
  given = law.given;
  if (all (given(1:3) == 0))   # it stands still
    law.durations((end + 1) / 2) = T;
    law.T = T;
    return;
  endif
  time_of = @(v) getfield (gs.plan.law_phases (given, v, law.sign), "T");
  room = given(1) - gs.plan.ramps_length (given, 0, -given(2), -given(3));
  if (! (room > 0))
    error (["%s: coordinate %d cannot take %.6g s, as long as the others, without a stop " ...
            "(alone: %.6g s): lower its limits, or take option synchronized = \"none\""], ...
           who, k, T, law.T);
  endif
  peak = abs (law.peak(1));
  if (law.sign * law.peak(1) < 0)
    error ("%s: coordinate %d cannot take %.6g s: it goes backwards all the way", who, k, T);
  endif
  law = gs.plan.law_phases (given, gs.plan.bisected_root (@(v) time_of (v) - T, 0, peak), law.sign);
endfunction
