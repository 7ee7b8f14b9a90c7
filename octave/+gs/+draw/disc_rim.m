## q = gs.draw.disc_rim (p)
## The rim of a disc: P holds its centre, a point of its axis as far from it as the rim, a point of
## the rim.

function q = disc_rim (p)
  spoke = p(:,3) - p(:,1);
  radius = norm (p(:,2) - p(:,1));
  other = cross ((p(:,2) - p(:,1)) / radius, spoke);
  angle = linspace (0, 2 * pi, 61);
  q = p(:,1) + spoke * cos (angle) + other * sin (angle);
endfunction
