## path = gs.plan.space_spline (who, path, matrices)
## The natural cubic spline through path.points over their distances, with the rotations MATRICES
## at them (none where they are empty): curve (a piecewise polynomial), knots and, closer, arc = the
## abscissae and the lengths of way there; turns (gs.plan.turning_spline); length, angle (of all
## turns from point to point).  An error of WHO where its tangent vanishes: there it turns back on
## itself and has no direction.

function path = space_spline (who, path, matrices)
  chords = sqrt (sumsq (diff (path.points, 1, 2)));
  if (any (chords == 0))
    error ("%s: points %d and %d of the spline are at one place", who, find (chords == 0, 1), ...
           find (chords == 0, 1) + 1);
  endif
  path.knots = [0, cumsum(chords)];
  path.curve = gsmbp_plan ("cubic", path.points, path.knots);
  slow = slowest (path.curve);
  smooth (who, path, slow);
  x = places (path, slow);
  path.arc = [x; 0, cumsum(gs.plan.arc_length (path.curve, x(1:end-1), x(2:end)))];
  path.length = path.arc(2,end);
  if (isempty (matrices))
    matrices = repmat (eye (3), 1, 1, columns (path.points));
  endif
  path.turns = gs.plan.turning_spline (matrices, path.knots);
  path.angle = sum (sqrt (sumsq (path.turns.between)));
endfunction

## the abscissae within the pieces where the derivative by the abscissa is least
function x = slowest (curve)
  c = reshape (curve.coefs, 3, curve.pieces, curve.order);
  x = [];
  for k = 1:curve.pieces
    rate = reshape (c(:,k,:), 3, curve.order)(:,1:end-1) .* (curve.order-1:-1:1);
    square = conv (rate(1,:), rate(1,:)) + conv (rate(2,:), rate(2,:)) ...
             + conv (rate(3,:), rate(3,:));
    at = roots (polyder (square));
    at = real (at(abs (imag (at)) <= 1e-6 * abs (at)))';
    x = [x, curve.breaks(k) + at(at > 0 & at < curve.breaks(k+1) - curve.breaks(k))];
  endfor
endfunction

## its speed over the distances of the points is about 1
function smooth (who, path, slow)
  x = sort ([path.knots, slow]);
  f = gsmbp_evaluate (path.curve, x, 1);
  k = find (sqrt (sumsq (f(:,:,2))) < 1e-6, 1);
  if (! isempty (k))
    piece = min (lookup (path.knots, x(k)), numel (path.knots) - 1);
    error (["%s: the spline turns back on itself between points %d and %d: its tangent " ...
            "vanishes at [%.6g, %.6g, %.6g]; expected points whose spline has a direction " ...
            "everywhere"], who, piece, piece + 1, f(:,k,1));
  endif
endfunction

## abscissae closer than the knots, and closer still about those where its derivative is small
function x = places (path, slow)
  n = numel (path.knots) - 1;
  x = [interp1(0:n, path.knots, linspace (0, n, 16*n + 1)), slow];
  f = gsmbp_evaluate (path.curve, slow, 2);
  speed = sqrt (sumsq (f(:,:,2), 1));
  for k = find (speed < 0.3)
    around = speed(k) / norm (f(:,k,3)) * 2 .^ (0:20);
    x = [x, slow(k) - around, slow(k) + around];
  endfor
  x = unique (x(x >= 0 & x <= path.knots(end)));
  x = x([true, diff(x) > 1e-12 * x(end)]);
endfunction
