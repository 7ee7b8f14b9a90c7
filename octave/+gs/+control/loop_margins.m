## r = gs.control.loop_margins (f, w, L = f (w), all_ = true)
## Margins of the loop F (a function of frequencies [rad/s]; -1 is critical), looked for on the
## rising frequencies W and refined: phase margin [rad] where |F| = 1 (the least of them), gain
## margin (the least factor above 1, and the largest below 1 where there is one) where F is real and
## negative, Ms = max |1/(1 + F)|, each with its frequency; delay margin [s].
## L: the values of F at W; ALL_: false leaves Ms out.

function r = loop_margins (f, w, L = f (w), all_ = true)
  r = struct ("phase", Inf, "crossover", NaN, "gain", Inf, "gain_down", 0, ...
              "phase_crossover", NaN, "Ms", NaN, "Ms_at", NaN, "delay", Inf);
  for k = changes (log (abs (L)))
    at = root (@(x) log (abs (f (x))), w(k), w(k+1));
    phase = mod (angle (f (at)) + 2 * pi, 2 * pi) - pi;
    if (abs (phase) < abs (r.phase))
      [r.phase, r.crossover] = deal (phase, at);
    endif
    r.delay = min (r.delay, mod (phase, 2 * pi) / at);
  endfor
  places = changes (imag (L));
  places = places(real (L(places)) < 0 | real (L(places + 1)) < 0);
  [~, order] = sort (abs (log (abs (L(places)))));   # those nearest to the circle
  for k = places(order(1:min (6, end)))
    at = root (@(x) imag (f (x)), w(k), w(k+1));
    g = -1 / real (f (at));
    if (g >= 1 && g < r.gain)
      [r.gain, r.phase_crossover] = deal (g, at);
    elseif (g > 0 && g < 1 && g > r.gain_down)
      r.gain_down = g;
    endif
  endfor
  if (! all_)
    return;
  endif
  [r.Ms, r.Ms_at] = peak (@(x) 1 ./ abs (1 + f (x)), w, 1 ./ abs (1 + L));
endfunction

function k = changes (v)
  k = find (sign (v(1:end-1)) .* sign (v(2:end)) <= 0 & isfinite (v(1:end-1)) ...
            & isfinite (v(2:end)))(:)';
endfunction

function at = root (g, a, b)
  at = fzero (g, [a, b], optimset ("TolX", eps));
endfunction

function [top, at] = peak (g, w, values)
  values(! isfinite (values)) = Inf;
  [~, order] = sort (values, "descend");
  [top, at] = deal (-Inf, NaN);
  for k = order(1:min (3, end))(:)'
    ends = w([max(k - 1, 1), min(k + 1, numel (w))]);
    x = fminbnd (@(x) -g (x), ends(1), ends(2), optimset ("TolX", 1e-11 * ends(2)));
    if (g (x) > top)
      [top, at] = deal (g (x), x);
    endif
  endfor
  if (values(order(1)) > top)
    [top, at] = deal (values(order(1)), w(order(1)));
  endif
endfunction
