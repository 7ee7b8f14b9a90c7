## top = gs.machine.resonance_peak (c, i, plant)
## The largest sensitivity Ms of the loop of the controller C on a PLANT, broken at its input I, the
## others closed, to some thousandths; infinite where it is not stable.

function top = resonance_peak (c, i, plant)
  c.plant = plant;
  [~, worst] = gs.control.closed_poles (c);
  if (worst >= 0)
    top = Inf;
    return;
  endif
  w = logspace (-4, 0, 800) * pi / c.period * (1 - 1e-9);
  L = gs.control.loop_response (c, i);
  S = 1 ./ abs (1 + L (w));
  [top, k] = max (S);
  if (k > 1 && k < numel (w))   # the parabola through the three highest
    p = polyfit (-1:1, S(k-1:k+1), 2);
    top = p(3) - p(2) ^ 2 / (4 * p(1));
  endif
endfunction
