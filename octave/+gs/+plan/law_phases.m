## law = gs.plan.law_phases (given, v, sign)
## The profile of GIVEN (h, v0, v1, V, A, J, all times SIGN) by way of the speed V: a law as of
## gs.plan.speed_profile.

function law = law_phases (given, v, sign)
  [h, v0, v1, V, A, J] = num2cell (given){:};
  way = h - gs.plan.ramps_length (given, v, v - v0, v - v1);
  cruise = 0;
  if (v != 0)
    cruise = max (0, way / v);
  endif
  [~, tj0, ta0] = gs.plan.speed_ramp (abs (v - v0), A, J);
  [~, tj1, ta1] = gs.plan.speed_ramp (abs (v - v1), A, J);
  up = sign * (1 - 2 * (v < v0));
  down = -sign * (1 - 2 * (v < v1));
  if (isinf (J))
    law.durations = [ta0, cruise, ta1];
    law.jerks = [0, 0, 0];
    starts = [up * A, 0, down * A];
    law.peak = [sign * v, up * A * (ta0 > 0), down * A * (ta1 > 0)];
  else
    law.durations = [tj0, ta0, tj0, cruise, tj1, ta1, tj1];
    law.jerks = J * [up, 0, -up, 0, down, 0, -down];
    starts = J * [0, up * tj0, up * tj0, 0, 0, down * tj1, down * tj1];
    law.peak = [sign * v, up * J * tj0, down * J * tj1];
  endif
  law.T = sum (law.durations);
  law.accelerations = starts;
  law.sign = sign;
  law.given = given;
  [law.switch_q, law.switch_v] = deal ([0, cumsum(0 * law.durations)]);
  law.switch_v(1) = sign * v0;
  for k = 1:numel (law.durations)
    t = law.durations(k);
    c = [law.jerks(k) / 6, starts(k) / 2, law.switch_v(k), law.switch_q(k)];
    law.switch_q(k+1) = polyval (c, t);
    law.switch_v(k+1) = polyval ([3, 2, 1] .* c(1:3), t);
  endfor
  small = 1e-12 * max (abs (law.switch_v));
  law.retraces = any (law.switch_v < -small) && any (law.switch_v > small);
endfunction
