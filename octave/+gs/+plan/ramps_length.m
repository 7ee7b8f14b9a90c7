## l = gs.plan.ramps_length (given, v, d0, d1)
## Way of the two ramps of a profile (GIVEN: h, v0, v1, V, A, J) by way of the speed V, which is
## D0 and D1 above v0 and v1.

function l = ramps_length (given, v, d0, d1)
  l = (given(2) + v) / 2 * gs.plan.speed_ramp (abs (d0), given(5), given(6)) ...
      + (given(3) + v) / 2 * gs.plan.speed_ramp (abs (d1), given(5), given(6));
endfunction
