## lines = gs.draw.axis_lines (s, o)
## The lines of gnuplot for the axes of the stage S; O: the options of gsmbp_animate.

function lines = axis_lines (s, o)
  letters = "xyz"(s.axes);
  lines = ...
      {"set tmargin 2.5", "set grid lt 1 lc rgb '#cccccc'", ...
       "set key Left reverse samplen 2 spacing 1.2", "set tics nomirror", "set tics scale 0.6", ...
           sprintf("set key at screen 0.5,%.5f top center vertical maxrows %d width 2", s.key)};
  for k = 1:numel (letters)
    c = "xyz"(k);
    lines{end+1} = sprintf ("set %slabel '%s [m]'; set %srange [%.9g:%.9g]", c, letters(k), c, ...
                            s.low(k), s.high(k));
    lines{end+1} = sprintf ("set %stics %.9g", c, tick (max (s.high - s.low) / 7));
  endfor
  if (numel (letters) == 2)
    lines = [lines, {"set size ratio -1", sprintf("set bmargin at screen %.5f", s.below)}];
  else
    sides = {"l", "r", "b", "t"};
    for k = 1:4
      lines{end+1} = sprintf ("set %smargin at screen %.5f", sides{k}, s.margins(k));
    endfor
    lines = [lines, {sprintf("set view %.4g,%.4g; set view equal xyz", o.view), ...
                     sprintf("set xyplane at %.9g", s.low(3)), "set border 127 lc rgb '#888888'"}];
  endif
endfunction

## 1, 2 or 5 times a power of ten, not below x
function step = tick (x)
  power = 10 ^ floor (log10 (x));
  step = [1 2 5 10](find ([1 2 5 10] * power >= x * (1 - 1e-9), 1)) * power;
endfunction

## -------------------------------------------------------------- the drawing
