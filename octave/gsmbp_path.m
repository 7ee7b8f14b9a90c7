## -*- texinfo -*-
## @c category Motions
## @deftypefn  {} {@var{path} =} gsmbp_path ("line", @var{points}, "speed", @var{v}, @
## "acceleration", @var{a}, @dots{})
## @deftypefnx {} {@var{path} =} gsmbp_path ("circle", @var{points}, @dots{})
## @deftypefnx {} {@var{path} =} gsmbp_path ("spline", @var{points}, @dots{})
## A straight line, an arc of a circle or a spline in space that a frame follows within limits of
## speed.
##
## @var{points}: 3 x 2 [m], from the first to the second; of a circle 3 x 3, from the first
## through the second to the third; of a spline 3 x @var{k}, through all of them (a natural cubic
## spline over their distances).  Options:
## @table @code
## @item "speed", "acceleration", "jerk"
## limits along the path [m/s, m/s^2, m/s^3]; without "jerk" the speed is a trapezoid, with it
## a double S.  Where the point stays they are those of the angle [rad/s, @dots{}].
## @item "rotations"
## 3 x 3 x 2: the rotation matrices at both ends (default: no rotation).  The frame turns about
## one axis by an angle in [0, pi], in proportion to the way (slerp); half a turn is about the axis
## whose largest component is positive.  Of a spline 3 x 3 x @var{k}, one at each point: angular
## velocity and acceleration are continuous along it.
## @item "start", "end", "at"
## speeds at both ends (default 0) and first time (default 0)
## @end table
##
## The result is a struct: @code{s}, the way as a function of time (a piecewise polynomial, as of
## @code{gsmbp_plan}), @code{length} [m], @code{angle} [rad], @code{times} of begin and end, and
## of a circle @code{centre}, @code{radius}, @code{normal}, @code{sweep}; of a spline @code{angle}
## is the sum of the turns from point to point.
## @code{gsmbp_along} tells where the frame is at any time.
##
## @c session octave
## @example
## >> path = gsmbp_path ("circle", [1 -1 0; 0 0 -1; 0 0 0], "speed", 0.3, "acceleration", 0.9);
## >> [path.sweep, path.times]
## ans =
##
##     4.7124         0   16.0413
## >> norm (gsmbp_along (path, path.times(2)).p - [0; -1; 0]) < 1e-12
## ans = 1
## @end example
##
## Errors: points on one line are no circle; neighbours at one place are no spline, nor is one that
## turns back on itself; a matrix that is no rotation; an option that is missing, unknown or not
## above 0.
## Source: own; the rotation vector between the ends; for splines Kang and Park, International
## Journal for Numerical Methods in Engineering 46 (1999).
## @seealso{gsmbp_along, gsmbp_plan}
## @end deftypefn

function path = gsmbp_path (kind, points, varargin)
  if (nargin < 2 || ! ischar (kind))
    print_usage ();
  endif
  who = "gsmbp_path";
  gs.given.check_kind (who, "argument kind", kind, {"line", "circle", "spline"});
  gs.given.check_kind (who, "argument points", points, "numbers");
  check_points (who, kind, points);
  table = {"speed", [], "positive"; "acceleration", [], "positive"; "jerk", [], "positive"
           "rotations", [], "numbers"; "start", 0, "number"; "end", 0, "number"; "at", 0, "number"};
  o = gs.given.call_options (who, table, varargin);
  if (isempty (o.speed) || isempty (o.acceleration))
    error ("%s: expected the options \"speed\" and \"acceleration\"", who);
  endif
  path = struct ("kind", kind, "points", double (points));
  if (strcmp (kind, "spline"))
    matrices = rotations (who, o.rotations, columns (points));
    path = gs.plan.space_spline (who, path, matrices);
  else
    matrices = rotations (who, o.rotations, 2);
    path.length = norm (diff (path.points(:,1:2), 1, 2));
    if (strcmp (kind, "circle"))
      path = circle (who, path);
    endif
    [path.rotation, path.axis, path.angle] = turning (matrices);
  endif
  path.s = law_of (path, o);
  path.times = path.s.breaks([1, end]);
endfunction

function check_points (who, kind, points)
  n = struct ("line", 2, "circle", 3, "spline", max (2, columns (points))).(kind);
  if (! isequal (size (points), [3, n]))
    error ("%s: argument points of a %s: expected 3 x %d%s, found %d x %d", who, kind, n, ...
           {"", " or more"}{1 + strcmp(kind, "spline")}, rows (points), columns (points));
  endif
endfunction

function s = law_of (path, o)
  way = path.length;
  if (way == 0)
    way = path.angle;
  endif
  limits = {"speed", o.speed, "acceleration", o.acceleration, "start", o.start, "end", o.end, ...
            "at", o.at};
  if (isempty (o.jerk))
    s = gsmbp_plan ("trapezoid", [0, way], limits{:});
  else
    s = gsmbp_plan ("double_s", [0, way], limits{:}, "jerk", o.jerk);
  endif
endfunction

## centre, radius, axes and angle of the arc through three points
function path = circle (who, path)
  a = path.points(:,2) - path.points(:,1);
  b = path.points(:,3) - path.points(:,1);
  n = cross (a, b);
  if (! (norm (n) > 1e-10 * norm (a) * norm (b)) || norm (a - b) <= 1e-10 * norm (a))
    error ("%s: the three points are collinear: no circle", who);
  endif
  to_centre = cross (dot (a, a) * b - dot (b, b) * a, n) / (2 * dot (n, n));
  path.normal = n / norm (n);
  path.centre = path.points(:,1) + to_centre;
  path.radius = norm (to_centre);
  path.first = -to_centre / path.radius;
  path.second = cross (path.normal, path.first);
  last = path.points(:,3) - path.centre;
  path.sweep = mod (atan2 (dot (path.second, last), dot (path.first, last)), 2 * pi);
  path.length = path.radius * path.sweep;
endfunction

## as many rotations as the path has points with one
function matrices = rotations (who, matrices, n)
  if (isempty (matrices))
    return;
  endif
  if (! isequal (size (matrices), [3, 3, n]))
    error ("%s: option rotations: expected 3 x 3 x %d, found %s", who, n, ...
           sprintf ("%dx", size (matrices))(1:end-1));
  endif
  for k = 1:n
    R = matrices(:,:,k);
    if (max (abs ((R' * R - eye (3))(:))) > 1e-6 || det (R) < 0)
      error (["%s: option rotations: matrix %d is no rotation: R'*R differs from 1 by %.3g, " ...
              "det R = %.3g"], ...
             who, k, max (abs ((R' * R - eye (3))(:))), det (R));
    endif
  endfor
endfunction

## the first rotation, and axis (in its frame) and angle of the turn to the second
function [R, axis, angle] = turning (matrices)
  if (isempty (matrices))
    [R, axis, angle] = deal (eye (3), [0; 0; 1], 0);
    return;
  endif
  R = matrices(:,:,1);
  [~, axis, angle] = gs.plan.rotation_vector (R' * matrices(:,:,2));
endfunction

%!test <a line with its orientation: half way at half time>
%! R = cat (3, eye (3), [1 0 0; 0 -1 0; 0 0 -1]);
%! p = gsmbp_path ("line", [0 1; 0 2; 0 2], "speed", 1, "acceleration", 2, "rotations", R);
%! assert ([p.length, p.angle, p.times], [3, pi, 0, 3.5], 1e-15);
%! f = gsmbp_along (p, 1.75);
%! assert (f.p, [0.5; 1; 1], 1e-15);
%! assert (f.R, [1 0 0; 0 0 -1; 0 1 0], 1e-15);
%! assert (f.omega, [pi/3; 0; 0], 1e-15);
%!test <a circle: distance from the centre, speed along it, acceleration towards the centre>
%! p = gsmbp_path ("circle", [1 0.3 -1; 2 2 1; 3 3.2 3.9], "speed", 0.3, "acceleration", ...
%!     1, "jerk", 5);
%! f = gsmbp_along (p, linspace (0, p.times(2), 7));
%! assert (norm (f.p - p.centre, "columns"), repmat (p.radius, 1, 7), 1e-14);
%! assert (f.p(:,end), [-1; 1; 3.9], 1e-14);
%! assert (dot (f.a(:,4), p.centre - f.p(:,4)) / p.radius, 0.09 / p.radius, 1e-14);
%!error <collinear> gsmbp_path ("circle", [0 0.5 1; 0 0 0; 0 0 0], "speed", 1, "acceleration", 1)
%!error <matrix 2 is no rotation>
%! gsmbp_path ("line", zeros (3, 2), "speed", 1, "acceleration", 1, "rotations", ...
%!             cat (3, eye (3), 2 * eye (3)))
