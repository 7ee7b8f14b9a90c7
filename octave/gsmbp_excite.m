## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{x} =} gsmbp_excite (@var{m}, "speed", @var{v}, @var{option}, @var{value}, @
## @dots{})
## A motion that excites the parameters of an open chain for @code{gsmbp_identify}, within limits.
##
## Each coordinate moves by a Fourier series of the same period,
## q = c + sum (a_k*sin (k*w*t) + b_k*cos (k*w*t)), so that whole periods can be averaged.  The
## coefficients make the motion keep its limits, always: each series is scaled to them.  What is
## left free is improved by quasi-Newton steps (@code{fminunc}) from several random starts, the best
## is taken; it is a local optimum.
##
## Options:
## @table @code
## @item "speed", "acceleration"
## limits [rad/s or m/s, .../s^2]: one number or one for each coordinate; "speed" must be given,
## "acceleration" is infinite by default
## @item "position"
## n x 2, least and largest (default the limits of the coordinates in the scene); or one number,
## both ways
## @item "effort"
## largest |effort| along the motion (default infinite), by the model as it is
## @item "goal"
## "condition" (default): the condition number of the weighted system; "determinant": D-optimal,
## the determinant of the covariance is least
## @item "sigma"
## standard deviations of the efforts, the weights of the rows (default 1)
## @item "period", "harmonics"
## [s] (default 10), at least 2 (default 5)
## @item "rest"
## true (default): it begins and ends at rest with acceleration 0
## @item "starts", "seed", "iterations"
## random starts (default 3), their seed (default 1), steps for each (default 20)
## @item "samples"
## rows of the system in a period (default 6 for each harmonic)
## @item "coulomb", "viscous", "rotor", "offset"
## further columns, as of @code{gsmbp_identify}
## @end table
##
## @var{x}: @code{motion}, one period as a piecewise polynomial of order 5 (of @code{gsmbp_plan}'s
## form; it agrees with the series to 1e-7 of its size), @code{offset}, @code{sine}, @code{cosine}
## (n x harmonics), @code{period}, @code{condition}, @code{condition_scaled}, @code{determinant}
## (log of the determinant of the weighted normal matrix), @code{use} of the limits of position,
## speed, acceleration, effort (n x 4, 1: all of it), @code{starts} (the goal that each start
## reached), @code{first} (what each began with).
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> x = gsmbp_excite (m, "speed", 4, "period", 5, "harmonics", 2, "starts", 2);
## >> x.starts < x.first, max (x.use) <= 1
## ans =
##
##   1  1
##
## ans = 1
## @end example
##
## Errors: a coordinate without limits; limits that hold no motion, efforts that weight alone
## passes; a scene with loops, or without REG.
## Source: Swevers, Ganseman, Tukel, De Schutter and Van Brussel (1997) (Fourier series); Gautier
## and Khalil (1992) (condition number).
## @seealso{gsmbp_identify, gsmbp_inverse}
## @end deftypefn

function x = gsmbp_excite (m, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_excite";
  gs.given.check_model (who, m);
  gs.given.check_open_chain (who, m);
  table = {"speed", [], "any"; "acceleration", Inf, "any"; "position", [], "any"
           "effort", Inf, "any"; "goal", "condition", {"condition", "determinant"}
           "sigma", 1, "numbers"; "period", 10, "positive"; "harmonics", 5, [2, 50]
           "rest", true, "flag"; "starts", 3, "whole"; "seed", 1, "whole"
           "iterations", 20, "whole"; "samples", [], "positive"
           "coulomb", false, "any"; "viscous", false, "any"; "rotor", false, "any"
           "offset", false, "any"};
  o = gs.given.call_options (who, table, varargin);
  o.motors = struct ("coordinate", {});
  o = limits_of (who, m, o);
  [coarse, fine] = deal (series (o, o.samples), series (o, 20 * o.harmonics));
  best.goal = Inf;
  state = randn ("twister");
  unwind_protect
    randn ("twister", o.seed);
    for k = 1:max (1, o.starts)
      y = randn (m.sizes.nu, columns (coarse.free) + 2);
      x.first(k) = goal_of (who, m, o, coarse, fine, y);
      [y, x.starts(k)] = improved (who, m, o, coarse, fine, y);
      if (x.starts(k) < best.goal)
        best = struct ("goal", x.starts(k), "y", y);
      endif
    endfor
  unwind_protect_cleanup
    randn ("twister", state);
  end_unwind_protect
  if (! isfinite (best.goal))
    error ("%s: no start gave a motion that excites all parameters within the limits", who);
  endif
  c = within_efforts (who, m, o, fine, scaled (o, fine, best.y));
  x = told (who, m, o, coarse, fine, c, x);
endfunction

function o = limits_of (who, m, o)
  n = m.sizes.nu;
  o.harmonics = round (o.harmonics);
  if (isempty (o.speed))
    error ("%s: expected the option speed, found none", who);
  endif
  for name = {"speed", "acceleration", "effort", "sigma"}
    v = o.(name{1})(:);
    if (isscalar (v))
      v = repmat (v, n, 1);
    endif
    if (! (isnumeric (v) && isreal (v) && numel (v) == n && all (v > 0)))
      error ("%s: option %s: expected one number above 0 or %d, found %s", who, name{1}, n, ...
             gs.text.shown_value (o.(name{1})));
    endif
    o.(name{1}) = v;
  endfor
  p = o.position;
  if (isempty (p))
    p = gs.model.scene_limits (m, m.coordinates);
  elseif (isscalar (p))
    p = repmat ([-p, p], n, 1);
  endif
  if (! (isnumeric (p) && isreal (p) && isequal (size (p), [n, 2]) && all (p(:,1) < p(:,2))))
    error ("%s: option position: expected %d x 2, least below largest, found %s", who, n, ...
           gs.text.shown_value (o.position));
  elseif (! all (isfinite (p(:))))
    k = find (! all (isfinite (p), 2), 1);
    error ("%s: %s has no limits: give option position, or limits in the scene", who, ...
           m.coordinates{k});
  endif
  o.position = p;
  if (isempty (o.samples))
    o.samples = 6 * o.harmonics;
  endif
endfunction

## sines and cosines and their derivatives at N times, and the combinations that are free
function s = series (o, n)
  H = o.harmonics;
  w = 2 * pi / o.period;
  s.t = (0:n-1)' * o.period / n;
  k = 1:H;
  [S, C] = deal (sin (w * s.t * k), cos (w * s.t * k));
  s.B = {[S, C], [C, -S] .* (w * [k, k]), -[S, C] .* (w * [k, k]) .^ 2};
  s.free = eye (2 * H);
  if (o.rest)
    s.free = null ([k, 0*k; 0*k, k.^2]);
  endif
endfunction

## coefficients within the limits of position, speed, acceleration: rows sine, cosine, offset; the
## last two of the free numbers are the amplitude and where the middle lies, in what is left
function c = scaled (o, s, y)
  part = 1 ./ (1 + exp (-y(:,end-1:end)));
  c.wave = (s.free * y(:,1:end-2)')';
  q = s.B{1} * c.wave';
  span = (max (q) - min (q))';
  most = @(k) max (abs (s.B{k} * c.wave'))';
  room = diff (o.position, 1, 2);
  factor = min ([room ./ span, o.speed ./ most(2), o.acceleration ./ most(3)], [], 2);
  c.wave .*= factor .* (0.2 + 0.8 * part(:,1));
  q = s.B{1} * c.wave';
  slack = room - (max (q) - min (q))';
  c.offset = o.position(:,1) - min (q)' + slack .* part(:,2);
endfunction

function d = motion_at (s, c)
  d = struct ("t", s.t, "q", s.B{1} * c.wave' + c.offset', "u", s.B{2} * c.wave', "ud", ...
              s.B{3} * c.wave', "other", struct (), "other_d", struct ());
  d.tau = zeros (size (d.q));
endfunction

## the goal, and how far the efforts pass their limits, as a penalty
function f = goal_of (who, m, o, coarse, fine, y)
  c = scaled (o, fine, y);
  w = gs.identify.regression_rows (who, m, motion_at (coarse, c), o);
  A = w.Y ./ o.sigma(w.group);
  l = svd (A);
  if (strcmp (o.goal, "condition"))
    f = log (l(1) / max (l(end), realmin));
  else
    f = -2 * sum (log (max (l, realmin)));
  endif
  tau = w.Y * w.p + w.r;
  f += 10 * sum (max (abs (tau) ./ o.effort(w.group) - 1, 0));
endfunction

function [y, f] = improved (who, m, o, coarse, fine, y)
  size_of = size (y);
  goal = @(v) goal_of (who, m, o, coarse, fine, reshape (v, size_of));
  options = optimset ("MaxIter", o.iterations, "TolFun", 1e-4, "TolX", 1e-4, "AutoScaling", "off");
  f = goal (y(:));
  if (o.iterations > 0)
    [v, g] = fminunc (goal, y(:), options);
    if (g < f)
      [y, f] = deal (reshape (v, size_of), g);
    endif
  endif
endfunction

## a smaller motion about the same middle where efforts pass their limits
function c = within_efforts (who, m, o, s, c)
  passes = @(f) max (efforts (m, s, smaller (c, f)) ./ o.effort') > 1;
  if (! any (passes (1)))
    return;
  endif
  [low, high] = deal (0, 1);
  if (any (passes (0)))
    k = find (passes (0), 1);
    error (["%s: option effort: %s: the weight alone passes %g where the motion stands: give " ...
            "other positions"], who, m.coordinates{k}, o.effort(k));
  endif
  for step = 1:40
    middle = (low + high) / 2;
    if (any (passes (middle)))
      high = middle;
    else
      low = middle;
    endif
  endfor
  c = smaller (c, low);
endfunction

function c = smaller (c, f)
  c.wave *= f;
endfunction

function tau = efforts (m, s, c)
  d = motion_at (s, c);
  tau = abs (m.module ("many", "inv", m.cst, d.t(:)', d.q', d.u', d.ud', ...
                       zeros (m.sizes.nv, 1)))';
endfunction

function x = told (who, m, o, coarse, fine, c, x)
  H = o.harmonics;
  [x.offset, x.sine, x.cosine] = deal (c.offset, c.wave(:,1:H), c.wave(:,H+1:end));
  x.period = o.period;
  w = gs.identify.regression_rows (who, m, motion_at (coarse, c), o);
  A = w.Y ./ o.sigma(w.group);
  x.condition = cond (A);
  x.condition_scaled = cond (A ./ norm (A, "columns"));
  x.determinant = 2 * sum (log (svd (A)));
  d = motion_at (fine, c);
  middle = mean (o.position, 2)';
  half = diff (o.position, 1, 2) / 2;
  x.use = [max(abs (d.q - middle))' ./ half, max(abs (d.u))' ./ o.speed, ...
           max(abs (d.ud))' ./ o.acceleration, max(efforts (m, fine, c))' ./ o.effort];
  x.motion = polynomial (fine, c, o.period);
endfunction

## order 5 between the times, with the values, speeds and accelerations there
function pp = polynomial (s, c, period)
  d = motion_at (s, c);
  h = period / numel (s.t);
  next = [2:numel(s.t), 1];
  [q, u, a] = deal (d.q', d.u' * h, d.ud' * h ^ 2);
  [Q, U, A] = deal (q(:,next), u(:,next), a(:,next));
  coefs = cat (3, 6*(Q - q) - 3*(U + u) + (A - a) / 2, 15*(q - Q) + 8*u + 7*U + 1.5*a - A, ...
               10*(Q - q) - 6*u - 4*U - 1.5*a + A / 2, a / 2, u, q);
  coefs ./= reshape (h .^ (5:-1:0), 1, 1, 6);
  pp = mkpp ([s.t', period], coefs, columns (d.q));
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! fail ("gsmbp_excite (m, \"period\", 2)", "expected the option speed, found none");
%! fail ("gsmbp_excite (m, \"speed\", 2)", "q has no limits: give option position");
%! fail ("gsmbp_excite (m, \"speed\", -2, \"position\", 1)", "expected one number above 0 or 1");
%! fail ("gsmbp_excite (m, \"speed\", 2, \"position\", [1 0])", "least below largest");
%! fail ("gsmbp_excite (m, \"speed\", 2, \"position\", 1)", "has no subroutine REG");
