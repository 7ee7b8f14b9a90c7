## -*- texinfo -*-
## @c category Motions
## @deftypefn  {} {@var{motion} =} gsmbp_plan ("quintic", @var{q}, @var{times})
## @deftypefnx {} {@var{motion} =} gsmbp_plan ("septic", @var{q}, @var{times})
## @deftypefnx {} {@var{motion} =} gsmbp_plan ("cubic", @var{q}, @var{times})
## @deftypefnx {} {@var{motion} =} gsmbp_plan ("blends", @var{q}, @var{times}, @
## "acceleration", @var{a})
## @deftypefnx {} {[@var{motion}, @var{laws}] =} gsmbp_plan ("trapezoid", @var{q}, @
## "speed", @var{v}, "acceleration", @var{a}, @dots{})
## @deftypefnx {} {[@var{motion}, @var{laws}] =} gsmbp_plan ("double_s", @var{q}, @
## "speed", @var{v}, "acceleration", @var{a}, "jerk", @var{j}, @dots{})
## @deftypefnx {} {@var{motion} =} gsmbp_plan ("profile", @var{rate}, @var{order}, @var{start})
## @deftypefnx {} {@var{motion} =} gsmbp_plan ("table", @var{times}, @var{values}, @var{order})
## Plan a motion, or make a table of inputs, as a piecewise polynomial.
##
## @table @code
## @item "quintic"
## from rest to rest: speed and acceleration are zero at both ends.  @var{q}
## holds the coordinates (one row each), a column for each of the @var{times}
## [s]: two columns for a single move, more for moves with a rest at each.
## The jerk jumps at the ends, and so does the voltage of a motor with
## inductance.
## @item "septic"
## the same with zero jerk at the ends
## @item "trapezoid"
## in the shortest time within limits of speed and acceleration, from column to column of
## @var{q}, at rest in those between.  A limit is one number, or one for each coordinate.
## "start", "end": speeds in the first and last column (default 0); "at": the first time;
## "synchronized": "time" (default), all coordinates arrive together, the quick ones at a
## lower speed; "line", all follow the same law, a straight line in their space (from rest to
## rest); "none", each as fast as it can.  The acceleration jumps.  A move without a way and
## without speeds lasts no time.  Where a way is too short for the speeds at its ends the
## coordinate goes back, and a warning says so.  @var{laws} (a row for each coordinate, a
## column for each move) tells @code{T}, @code{durations} of the phases, positions and speeds
## between them, @code{switch_q} and @code{switch_v}, @code{peak} (speed, both accelerations)
## and whether it @code{retraces}.
## @item "double_s"
## the same with a limit of the jerk: seven phases; the acceleration is zero at both ends and
## continuous, the jerk jumps
## @item "cubic"
## a spline of order 3 through the columns of @var{q} at the @var{times}, second derivative
## zero at both ends, or speeds "start", "end" there
## @item "blends"
## straight lines from column to column, joined by parabolas of the given acceleration: it
## passes near the via points, and begins and ends at rest in the first and last
## @item "profile"
## @var{rate} is a piecewise polynomial (as of @code{mkpp}) of the coordinates'
## derivative of the given @var{order} (1 velocity, 2 acceleration); it is
## integrated.  @var{start}: the values at the first break, one row for each
## coordinate, columns position, velocity, @dots{} (@var{order} columns; zeros
## by default).
## @item "table"
## @var{values}: one row for each of the @var{times}, a column for each
## quantity.  @var{order} 0 holds each value until the next time, 1 is linear,
## 3 a cubic spline (not-a-knot).
## @end table
##
## The result is Octave's own form (@code{ppval} works on it);
## @code{gsmbp_evaluate} gives values and derivatives from either side of a
## break.
##
## @c session octave
## @example
## >> plan = gsmbp_plan ("quintic", [0 1; 0 -0.5], [0 2]);
## >> gsmbp_evaluate (plan, 1)'
## ans =
##
##    0.5000  -0.2500
## >> [plan, law] = gsmbp_plan ("double_s", [0 10], "speed", 5, "acceleration", 10, "jerk", 30);
## >> [law.T, law.peak]
## ans =
##
##     2.8333    5.0000   10.0000  -10.0000
## >> speed = gsmbp_plan ("profile", mkpp ([0 1 2 6], [4 0; -4 4; 0 0]), 2);
## >> squeeze (gsmbp_evaluate (speed, [1 2 6], 1))
## ans =
##
##     0.6667    2.0000
##     4.0000    4.0000
##    20.0000    4.0000
## @end example
##
## Errors: an unknown kind; positions, times or values of other sizes or not
## finite; an order that the kind has not; speeds above their limit; a coordinate that cannot
## take as long as the others without a stop; blends that overlap.
## Source: polynomials of order 5 and 7 with given end values; splines as in
## Octave; Biagiotti and Melchiorri, Trajectory Planning for Automatic Machines and Robots
## (trapezoid, double S); Craig, Introduction to Robotics (blends).
## @seealso{gsmbp_evaluate, gsmbp_path, gsmbp_retime, gsmbp_inverse, gsmbp_simulate}
## @end deftypefn

function [motion, laws] = gsmbp_plan (kind, varargin)
  if (nargin < 2 || ! ischar (kind))
    print_usage ();
  endif
  counted (kind, varargin);
  switch (kind)
    case {"quintic", "septic"}
      motion = moves (varargin{:}, ...
                      struct ("quintic", [6 -15 10 0 0 0], "septic", ...
                              [-20 70 -84 35 0 0 0 0]).(kind));
    case {"trapezoid", "double_s"}
      numbers (varargin{1}, "the positions");
      [motion, laws] = gs.plan.limited_motion ("gsmbp_plan", double (varargin{1}), ...
                                               varargin(2:end), strcmp (kind, "double_s"));
    case {"cubic", "blends"}
      [q, times] = columns_at (varargin{1:2});
      motion = gs.plan.via_points ("gsmbp_plan", kind, q, times, varargin(3:end));
    case "profile"
      motion = profile (varargin{:});
    case "table"
      motion = table (varargin{:});
    otherwise
      error (["gsmbp_plan: kind must be \"quintic\", \"septic\", \"trapezoid\", " ...
              "\"double_s\", \"cubic\", \"blends\", \"profile\" or \"table\", found: \"%s\""], ...
             kind);
  endswitch
endfunction

## whether a kind is given as many arguments as it takes; options may follow those of some
function counted (kind, given)
  table = {"quintic", 2, 2, "positions and times"; "septic", 2, 2, "positions and times"
           "cubic", 2, Inf, "positions, times and options"
           "blends", 2, Inf, "positions, times and options"
           "profile", 1, 3, "a rate, an order and a start"
           "table", 2, 3, "times, values and an order"};
  k = find (strcmp (table(:,1), kind));
  n = numel (given);
  if (isempty (k))
    return;
  endif
  texts = find (cellfun (@ischar, given), 1);
  if (n < table{k,2} || n > table{k,3} || any (texts <= table{k,2}))
    error ("gsmbp_plan: %s: expected %s, found %s", kind, table{k,4}, ...
           strjoin (cellfun (@gs.text.shown_value, given, "UniformOutput", false), ", "));
  endif
endfunction

## positions, a column for each of the times
function [q, times] = columns_at (q, times)
  times = gs.given.given_times ("gsmbp_plan", times);
  numbers (q, "the positions");
  if (columns (q) != numel (times) || numel (times) < 2)
    error (["gsmbp_plan: expected a column of positions for each of the %d times (two " ...
            "or more), found %d x %d"], numel (times), rows (q), columns (q));
  endif
  q = double (q);
endfunction

## q0 + (q1 - q0)*shape ((t - t0)/(t1 - t0)) on each piece
function motion = moves (q, times, shape)
  [q, times] = columns_at (q, times);
  n = rows (q);
  k = numel (shape);
  pieces = numel (times) - 1;
  coefs = zeros (n, pieces, k);
  for p = 1:pieces
    scale = (times(p+1) - times(p)) .^ -(k-1:-1:0);
    coefs(:,p,:) = (q(:,p+1) - q(:,p)) * (shape .* scale);
    coefs(:,p,k) = q(:,p);
  endfor
  motion = mkpp (times, coefs, n);
endfunction

function motion = profile (rate, order = 1, start = [])
  if (! (isstruct (rate) && isfield (rate, "form") && strcmp (rate.form, "pp")))
    error ("gsmbp_plan: the profile must be a piecewise polynomial, as of mkpp, found %s", ...
           gs.text.shown_value (rate));
  endif
  gs.given.check_kind ("gsmbp_plan", "argument start", start, "numbers");
  if (! (isnumeric (order) && isscalar (order) && any (order == [1 2 3])))
    error (["gsmbp_plan: the order of the profile must be 1 (velocity), 2 " ...
            "(acceleration) or 3 (jerk), found %s"], gs.text.shown_value (order));
  endif
  n = prod (rate.dim);
  if (isempty (start))
    start = zeros (n, order);
  endif
  if (! isequal (size (start), [n order]))
    error (["gsmbp_plan: expected the start as %d x %d (a row for each coordinate), " ...
            "found %d x %d"], n, order, rows (start), columns (start));
  endif
  motion = rate;
  for i = order:-1:1
    motion = integral_of (motion, start(:,i));
  endfor
endfunction

function pp = integral_of (pp, start)
  n = prod (pp.dim);
  c = reshape (pp.coefs, n, pp.pieces, pp.order);
  k = pp.order;
  d = cat (3, c ./ reshape (k:-1:1, 1, 1, k), zeros (n, pp.pieces));
  h = diff (pp.breaks);
  for p = 1:pp.pieces
    d(:,p,k+1) = start;
    start = reshape (d(:,p,:), n, k + 1) * (h(p) .^ (k:-1:0)');
  endfor
  pp = mkpp (pp.breaks, d, n);
endfunction

function motion = table (times, values, order = 1)
  times = gs.given.given_times ("gsmbp_plan", times);
  numbers (values, "the values");
  nt = numel (times);
  if (rows (values) == 1 && columns (values) == nt)
    values = values.';
  endif
  if (rows (values) != nt || nt < 2)
    error (["gsmbp_plan: expected a row of values for each of the %d times (two or " ...
            "more), found %d x %d"], nt, rows (values), columns (values));
  endif
  gs.given.check_kind ("gsmbp_plan", "argument order", order, "whole");
  n = columns (values);
  h = diff (times)';
  switch (order)
    case 0
      coefs = reshape (values(1:nt-1,:).', n, nt - 1, 1);
      ## the last value holds from the last time on
      coefs(:,nt,1) = values(nt,:).';
      times(nt+1) = times(nt) + max (h);
    case 1
      coefs = cat (3, (diff (values) ./ h).', values(1:nt-1,:).');
    case 3
      pp = spline (times, values.');
      coefs = reshape (pp.coefs, n, pp.pieces, pp.order);
      times = pp.breaks;
    otherwise
      error ("gsmbp_plan: the order of a table must be 0, 1 or 3, found %s", ...
             gs.text.shown_value (order));
  endswitch
  motion = mkpp (times, coefs, n);
endfunction

function numbers (x, what)
  if (! (isnumeric (x) && isreal (x) && ndims (x) == 2))
    error ("gsmbp_plan: %s must be a matrix of finite real numbers, found %s", what, ...
           gs.text.shown_value (x));
  endif
  gs.given.check_table ("gsmbp_plan", what, x);
endfunction

%!test <quintic: values, speeds, accelerations at the ends>
%! p = gsmbp_plan ("quintic", [0.5 0; -0.75 1], [1 3]);
%! f = gsmbp_evaluate (p, [1 2 3], 3);
%! assert (f(:,:,1), [0.5 0.25 0; -0.75 0.125 1], 1e-15);
%! assert (f(:,[1 3],2:3), zeros (2, 2, 2), 1e-13);
%! assert (f(1,2,2), -0.5 * 15/8 / 2, 1e-14);
%!test <septic: jerk too>
%! f = gsmbp_evaluate (gsmbp_plan ("septic", [0 2], [0 1]), [0 1], 4);
%! assert (f(1,:,1), [0 2], 1e-13);
%! assert (f(1,:,2:4), zeros (1, 2, 3), 1e-10);
%! assert (abs (f(1,:,5)), [1680 1680], 1e-9);
%!test <the profile of figure 7: 0 to 4 rad/s in 2 s>
%! p = gsmbp_plan ("profile", mkpp ([0 1 2 6], [4 0; -4 4; 0 0]), 2);
%! f = gsmbp_evaluate (p, [0 1 2 6], 2);
%! assert (f(1,:,2), [0 2 4 4], 1e-15);
%! assert (f(1,:,1), [0 2/3 4 20], 1e-14);
%! left = gsmbp_evaluate (p, 1, 3, -1);
%! right = gsmbp_evaluate (p, 1, 3, 1);
%! assert ([left(1,1,3) right(1,1,3) left(1,1,4) right(1,1,4)], [4 4 4 -4]);
%!test <tables>
%! t = [0 1 3];
%! assert (ppval (gsmbp_plan ("table", t, [1 2 4]', 1), 2), 3, 1e-15);
%! assert (gsmbp_evaluate (gsmbp_plan ("table", t, [1 2 4]', 0), [0.5 1 3 9]), [1 2 4 4]);
%! s = gsmbp_plan ("table", 0:0.1:1, [sin(0:0.1:1); cos(0:0.1:1)]', 3);
%! assert (gsmbp_evaluate (s, 0.55), [sin(0.55); cos(0.55)], 1e-5);
%!error <column of positions for each of the 2 times> gsmbp_plan ("quintic", [1 2 3], [0 1])
%!error <times must be strictly increasing> gsmbp_plan ("quintic", [1 2], [1 1])
%!error <kind must be> gsmbp_plan ("spline", [1 2], [0 1])
%!error <cubic: expected positions, times and options, found \[1 2\]> gsmbp_plan ("cubic", [1 2])
%!error <blends: expected positions, times and options, found \[1 2\], "acceleration", 3>
%! gsmbp_plan ("blends", [1 2], "acceleration", 3)
%!error <septic: expected positions and times, found \[1 2\]> gsmbp_plan ("septic", [1 2])
%!error <profile: expected a rate, an order and a start, found 1, 2, 3, 4>
%! gsmbp_plan ("profile", 1, 2, 3, 4)
%!error <table: expected times, values and an order, found \[0 1\]> gsmbp_plan ("table", [0 1])
%!error <option "speed" has no value> gsmbp_plan ("trapezoid", [0 1], "speed")
%!error <option acceleration: expected one number above 0, found none>
%! gsmbp_plan ("double_s", [0 1], "speed", 1)
%!error <option jerk: expected one number or 2 numbers above 0, found none>
%! gsmbp_plan ("double_s", [0 1; 0 2], "speed", 1, "acceleration", 2)
%!error <option speed: expected one number above 0, found -1>
%! gsmbp_plan ("double_s", [0 1], "speed", -1)
