## y = gs.identify.zero_phase (x, h, cutoff, order)
## The columns of X, sampled every H seconds, through a Butterworth filter of ORDER (even) and
## CUTOFF [Hz], forward and backward: no shift in time, the amplitude at the cutoff halved.  Both
## ends are continued by point reflection.

function y = zero_phase (x, h, cutoff, order)
  sections = second_order (h, cutoff, order);
  n = rows (x);
  reach = min (n - 1, ceil (3 * order / (2 * pi * cutoff * h)) + 3 * order);
  y = [2*x(1,:) - x(reach+1:-1:2,:); x; 2*x(n,:) - x(n-1:-1:n-reach,:)];
  for pass = 1:2
    for s = sections
      y = settled (s.b, s.a, y);
    endfor
    y = flipud (y);
  endfor
  y = y(reach+(1:n),:);
endfunction

## a section that begins where its first value has always been
function y = settled (b, a, x)
  first = x(1,:);
  y = first + filter (b, a, x - first);
endfunction

## the sections of the filter, by the bilinear transformation with the cutoff kept
function s = second_order (h, cutoff, order)
  w = tan (pi * cutoff * h);
  for k = 1:order / 2
    c = 2 * sin (pi * (2 * k - 1) / (2 * order)) * w;
    g = 1 + c + w ^ 2;
    s(k) = struct ("b", w ^ 2 * [1 2 1] / g, "a", [g, 2*(w ^ 2 - 1), 1 - c + w ^ 2] / g);
  endfor
endfunction
