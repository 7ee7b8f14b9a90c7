## [back, front, piston] = gs.draw.cylinder_housing (one, long)
## Where the housing of a cylinder begins and ends, as long in all poses, and where its piston is
## when its ends are LONG apart: distances from the first end towards the second [m].  Where the
## ends come too close for that (those of a sliding joint) the housing stands behind the first one.

function [back, front, piston] = cylinder_housing (one, long)
  [back, front] = deal (0, 0.9 * one.least);
  piston = min (max (long - 0.85 * front, 0.05 * front), 0.95 * front);
  stroke = one.largest - one.least;
  if (stroke > 0.8 * front)
    [back, front] = deal (-1.2 * stroke, 0);
    piston = long - one.largest - 0.1 * stroke;
  endif
endfunction
