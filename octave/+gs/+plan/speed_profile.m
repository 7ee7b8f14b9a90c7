## law = gs.plan.speed_profile (h, v0, v1, V, A, J)
## The shortest motion over H from speed V0 to V1 within speed V, acceleration A and jerk J
## (Inf: a trapezoid of speed) that goes from V0 to a peak and from it to V1, each in one ramp.
## LAW: T, durations (seven; three of a trapezoid), values there: switch_q, switch_v; peak
## (speed and both accelerations), jerks and accelerations (at the beginning of each phase),
## retraces (the speed changes its sign), sign (-1: the peak is below V0 and V1, because H is
## too short for the speeds) and `given`, the arguments times that sign.

function law = speed_profile (h, v0, v1, V, A, J)
  direct = (v0 + v1) / 2 * gs.plan.speed_ramp (abs (v1 - v0), A, J);
  near = 4 * eps * max (abs (h), max (v0^2, v1^2) / A);
  signs = [1, -1];
  if (abs (h - direct) <= near && (v0 != 0 || v1 != 0))
    h = direct;
  elseif (isinf (J))
    signs = 1 - 2 * (h < direct);
  endif
  law = struct ("T", Inf);
  for sign = signs
    given = [sign * [h, v0, v1], V, A, J];
    for v = peaks (given)
      other = gs.plan.law_phases (given, v, sign);
      if (other.T < law.T)
        law = other;
      endif
    endfor
  endfor
endfunction

## peak speeds >= v0, v1 whose two ramps are h long, V where they are shorter
function v = peaks (given)
  [h, v0, v1, V, A, J] = num2cell (given){:};
  top = max (v0, v1);
  excess = @(w) h - gs.plan.ramps_length (given, top + w, w + top - v0, w + top - v1);
  from = max (0, -top);
  v = [];
  if (excess (V - top) >= 0)
    v = V;
  elseif (isinf (J))
    v = max (top, sqrt (max (0, A * h + (v0^2 + v1^2) / 2)));
  elseif (excess (from) >= 0)
    v = top + gs.plan.bisected_root (excess, from, V - top);
  endif
  if (top < 0 && ! isinf (J))   # both speeds lead away: the ramps need not grow with the peak
    w = linspace (0, from, 257);
    e = arrayfun (excess, w);
    for k = find (e(1:end-1) .* e(2:end) <= 0)
      v(end+1) = top + gs.plan.bisected_root (@(x) sign (e(k) - e(k+1)) * excess (x), w(k), w(k+1));
    endfor
  endif
endfunction
