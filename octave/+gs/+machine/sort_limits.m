## s = gs.machine.sort_limits (s)
## The catalogue of the specification S within its supply: voltage and current of the amplifiers.

function s = sort_limits (s)
  for k = 1:numel (s.motors)
    s.motors(k).V_max = min (s.motors(k).V_max, s.supply);
    s.motors(k).T_peak = min (s.motors(k).T_peak, s.motors(k).Kt * s.current);
  endfor
endfunction
