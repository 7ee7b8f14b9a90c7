## -*- texinfo -*-
## @c category Motions
## @deftypefn  {} {@var{f} =} gsmbp_along (@var{path}, @var{times})
## @deftypefnx {} {@var{f} =} gsmbp_along (@var{path}, @var{times}, @var{side})
## Where the frame of a path is at each of the @var{times} [s].
##
## @var{path} is of @code{gsmbp_path}; @var{side} (default 1): which limit to take where the
## acceleration jumps, -1 from the left.  The result is a struct, a column (of the matrices a
## page) for each time, in the axes in which the points of the path were given:
## @table @code
## @item s
## the way, its rate and its second rate (3 rows)
## @item p, v, a
## position [m], velocity, acceleration
## @item R
## 3 x 3 x times: the rotation matrix
## @item omega, alpha
## angular velocity [rad/s] and acceleration
## @end table
##
## @c session octave
## @example
## >> path = gsmbp_path ("line", [0 1; 0 0; 0 0], "speed", 0.5, "acceleration", 1);
## >> f = gsmbp_along (path, [0.2 1]);
## >> [f.p(1,:); f.v(1,:); f.a(1,:)]
## ans =
##
##    0.0200   0.3750
##    0.2000   0.5000
##    1.0000        0
## @end example
##
## Errors: a path that is not of @code{gsmbp_path}; times that are not finite.
## Source: own.
## @seealso{gsmbp_path, gsmbp_evaluate}
## @end deftypefn

function f = gsmbp_along (path, times, side = 1)
  if (nargin < 2)
    print_usage ();
  endif
  if (! (isstruct (path) && isscalar (path) && all (isfield (path, {"kind", "s", "times"}))))
    error ("gsmbp_along: expected a path of gsmbp_path, found %s", gs.text.shown_value (path));
  endif
  s = reshape (gsmbp_evaluate (path.s, times, 2, side), [], 3)';
  f = struct ("s", s);
  if (strcmp (path.kind, "spline"))
    f = gs.plan.along_spline (path, s, f);
    return;
  endif
  [f.p, f.v, f.a] = place (path, s);
  ratio = path.angle;
  if (path.length > 0)
    ratio = path.angle / path.length;
  elseif (path.angle > 0)
    ratio = 1;
  endif
  axis = path.rotation * path.axis;
  f.omega = axis * (ratio * s(2,:));
  f.alpha = axis * (ratio * s(3,:));
  f.R = zeros (3, 3, columns (s));
  for k = 1:columns (s)
    f.R(:,:,k) = path.rotation * gs.plan.rotation_matrix (ratio * s(1,k) * path.axis);
  endfor
endfunction

function [p, v, a] = place (path, s)
  if (strcmp (path.kind, "circle"))
    phi = s(1,:) / path.radius;
    out = path.first * cos (phi) + path.second * sin (phi);
    along = path.second * cos (phi) - path.first * sin (phi);
    p = path.centre + path.radius * out;
    v = along .* s(2,:);
    a = along .* s(3,:) - out .* (s(2,:).^2 / path.radius);
    return;
  endif
  along = zeros (3, 1);
  if (path.length > 0)
    along = diff (path.points, 1, 2) / path.length;
  endif
  p = path.points(:,1) + along * (s(1,:) * (path.length > 0));
  v = along * s(2,:);
  a = along * s(3,:);
endfunction

%!error <expected a path of gsmbp_path> gsmbp_along (1, 2)
