## -*- texinfo -*-
## @c category Motions
## @deftypefn  {} {@var{motion} =} gsmbp_retime (@var{m}, @var{path}, @var{limit}, @
## @var{value}, @dots{})
## @deftypefnx {} {@var{motion} =} gsmbp_retime (@var{m}, @var{path})
## @deftypefnx {} {[@var{motion}, @var{told}] =} gsmbp_retime (@dots{})
## The least time in which a model can follow a path.
##
## @var{path} is a piecewise polynomial (of @code{gsmbp_plan}) of the actuated coordinates, or
## of all coordinates of an open chain; its abscissa s is no time: only the way counts.  Limits,
## one number
## for all coordinates, a number or a row [least, largest] for each (a number is both ways):
## @table @code
## @item "speed"
## of the planned coordinates
## @item "effort"
## of them, as @code{gsmbp_inverse} gives @code{tau}
## @item "input"
## inputs of the scene, the drives as quasi-static (@code{gsmbp_inverse}, "quasistatic"); they must
## be linear in the acceleration along the path (default: their @code{limits} in the scene; Inf:
## none)
## @end table
## Options: "start", "end": rates of s [1/s] at both ends (default 0); "rtol": the relative
## error of the time, as doubling the points tells it (default 3e-7); "points": how many there
## are at least
## (default 250); "guess" as in @code{gsmbp_inverse}.
##
## @var{motion} follows the path, in time, with an acceleration that jumps: follow it by
## @code{gsmbp_inverse} with "quasistatic".  @var{told}: @code{T} [s], @code{s}, @code{rate}
## (ds/dt),
## @code{t} at the points, @code{limited} (a cell array: what ends the acceleration between them),
## @code{change} (relative, of the last doubling).
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> path = gsmbp_plan ("table", [0 1], [0.2; 1.2]);
## >> [motion, told] = gsmbp_retime (m, path, "input", 24, "rtol", 1e-4);
## >> r = gsmbp_inverse (m, motion, told.t(2:end-1), "quasistatic", true);
## >> max (abs (r.v)) < 24.1
## ans = 1
## @end example
##
## Errors: a path that is none or of other components; no limit here and in the scene, or one of
## another size; efforts that are not quadratic in the speed (friction other than viscous and dry);
## a place on the path where no speed keeps the limits.
## Source: Pham and Pham, IEEE Transactions on Robotics 34 (2018), reachable sets, here on
## midpoints.
## @seealso{gsmbp_plan, gsmbp_inverse, gsmbp_path}
## @end deftypefn

function [motion, told] = gsmbp_retime (m, path, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_retime";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "path", path);
  [path, planned] = gs.given.given_motion (who, m, path);
  table = {"speed", [], "any"; "effort", [], "any"; "input", [], "any"
           "start", 0, "nonnegative"; "end", 0, "nonnegative"; "rtol", 3e-7, "tolerance"
           "points", 250, "positive"; "guess", m.initial(1:m.sizes.nq), "numbers"};
  o = gs.given.call_options (who, table, varargin);
  if (m.sizes.nq != m.sizes.nu)
    error ("%s: %s has Euler parameters: a planned motion cannot state its coordinates", ...
        who, m.name);
  endif
  moving (who, path);
  limits = gs.plan.motion_limits (who, m, o, numel (planned));
  cells = ceil (o.points);
  told = one_way (who, m, path, planned, limits, o, cells, []);
  doublings = 0;
  do
    doublings++;
    before = told.T;
    cells *= 2;
    told = one_way (who, m, path, planned, limits, o, cells, [told.singular, switched(told)]);
    told.change = abs (told.T - before) / told.T;
    alike = doublings > 1 || o.rtol > 1e-4;   # the first time points gather at new places
  until ((alike && told.change <= 3 * o.rtol) || cells >= 8000)   # its error falls to a quarter
  if (told.change > 3 * o.rtol)
    warning ("gsmbp:retime", "%s: the time still changes by %.1e of itself with %d points", who, ...
             told.change, cells);
  endif
  motion = in_time (path, told);
endfunction

## a path that stands still somewhere has no way there
function moving (who, path)
  for side = [-1, 1]
    still = all (abs (gsmbp_evaluate (path, path.breaks, 1, side)(:,:,2)) < 1e-12, 1);
    if (any (still))
      error (["%s: the path stands still at s = %g: expected one that moves everywhere, as a " ...
              "plan \"table\" or \"cubic\""], who, path.breaks(find (still, 1)));
    endif
  endfor
endfunction

function told = one_way (who, m, path, planned, limits, o, cells, about)
  s = places (path, cells, about);
  rows = gs.plan.path_limits (who, m, path, planned, limits, s, o.guess);
  [x, told.limited] = gs.plan.fastest_rates (who, s, rows, [o.start, o.end] .^ 2);
  told.s = s;
  told.singular = rows.singular;
  told.rate = sqrt (x);
  told.t = [0, cumsum(2 * diff (s) ./ (told.rate(1:end-1) + told.rate(2:end)))];
  told.T = told.t(end);
endfunction

## the places where another limit takes over; of many, where limits come and go, 20 along the path
function s = switched (told)
  s = told.s(1 + find (! strcmp (told.limited(1:end-1), told.limited(2:end))));
  if (numel (s) > 20)
    s = s(round (linspace (1, end, 20)));
  endif
endfunction

## breaks of the path and points between, closer towards the ends, and around the places ABOUT:
## where a limited quantity has no inertia, where another limit takes over
function s = places (path, cells, about)
  b = path.breaks;
  long = b(end) - b(1);
  w = (1 - cos (pi * (0:cells) / cells)) / 2;
  s = b(1) + long * w .^ 2 .* (3 - 2 * w);
  for at = about
    around = 4 * long / cells * 1.5 .^ -(0:25);
    s = [s, at - around, at, at + around];
  endfor
  s = unique ([min(max (s, b(1)), b(end)), b]);
  keep = [true, diff(s) > 1e-11 * long];
  keep(ismember (s, b)) = true;
  s = s(keep);
endfunction

## the path where s is quadratic in time between the points
function motion = in_time (path, told)
  n = prod (path.dim);
  c = reshape (path.coefs, n, path.pieces, path.order);
  k = numel (told.s) - 1;
  coefs = zeros (n, k, 2 * path.order - 1);
  for i = 1:k
    piece = max (1, min (path.pieces, sum ((told.s(i) + told.s(i+1)) / 2 >= path.breaks(1:end-1))));
    dt = told.t(i+1) - told.t(i);
    inner = [(told.rate(i+1) - told.rate(i)) / (2 * dt), told.rate(i), ...
        told.s(i) - path.breaks(piece)];
    for j = 1:n
      coefs(j,i,:) = composed (reshape (c(j,piece,:), 1, []), inner);
    endfor
  endfor
  motion = mkpp (told.t, coefs, n);
endfunction

## the polynomial outer (inner (t))
function p = composed (outer, inner)
  p = zeros (1, 2 * numel (outer) - 1);
  p(end) = outer(1);
  for k = 2:numel (outer)
    p = conv (p, inner)(end-numel (p)+1:end);
    p(end) += outer(k);
  endfor
endfunction

%!test <a drive without losses: half accelerated, half braked>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_set (gsmbp_hand ("motor_pendulum"), "g", 0, "b", 0);
%! J = m.mas (0, 0);
%! path = gsmbp_plan ("table", [0 1], [0.3; 1.1]);
%! [motion, told] = gsmbp_retime (m, path, "effort", 2, "rtol", 1e-3);
%! assert (told.T, 2 * sqrt (J * 0.8 / 2), 1e-9);
%! assert (told.limited{1}, "effort of q");
%! assert (gsmbp_evaluate (motion, told.T / 2), 0.7, 1e-9);
%! [~, told] = gsmbp_retime (m, path, "effort", 2, "speed", 0.5, "rtol", 1e-3);
%! assert (told.T, 0.8 / 0.5 + 0.5 * J / 2, 1e-5);
%!error <expected a limit: speed, effort or input>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_retime (gsmbp_hand ("motor_pendulum"), gsmbp_plan ("table", [0 1], [0; 1]), "rtol", 1e-3);
