## path = gsmbp__space_spline (who, path, matrices)
## The natural cubic spline through path.points over their distances, with the rotations MATRICES
## at them (none where they are empty): curve (a piecewise polynomial), knots and, closer, arc = the
## abscissae and the lengths of way there; turns (gsmbp__turning_spline); length, angle (of all
## turns from point to point), rotation and axis of the first of them.

function path = gsmbp__space_spline (who, path, matrices)
  chords = sqrt (sumsq (diff (path.points, 1, 2)));
  if (any (chords == 0))
    error ("%s: points %d and %d of the spline are at one place", who, find (chords == 0, 1), ...
           find (chords == 0, 1) + 1);
  endif
  path.knots = [0, cumsum(chords)];
  path.curve = gsmbp_plan ("cubic", path.points, path.knots);
  x = interp1 (0:numel (chords), path.knots, linspace (0, numel (chords), 16*numel (chords) + 1));
  ways = arrayfun (@(k) gsmbp__way (path.curve, x(k), x(k+1)), 1:numel (x) - 1);
  path.arc = [x; 0, cumsum(ways)];
  path.length = path.arc(2,end);
  if (isempty (matrices))
    matrices = repmat (eye (3), 1, 1, columns (path.points));
  endif
  path.turns = gsmbp__turning_spline (matrices, path.knots);
  path.angle = sum (sqrt (sumsq (path.turns.between)));
  path.rotation = matrices(:,:,1);
  path.axis = [0; 0; 1];
endfunction
