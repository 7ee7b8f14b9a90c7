## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{e} =} gsmbp_identify (@var{m}, @var{data})
## @deftypefnx {} {@var{e} =} gsmbp_identify (@var{m}, @var{data}, @var{option}, @var{value}, @
## @dots{})
## Estimate the base parameters of an open chain, with friction and motor constants, from a measured
## motion and its efforts.
##
## @var{m} was derived with the request @code{regressor}: its efforts are Y*p + r, linear in the
## base parameters p (@code{gsmbp_base_parameters}).  @var{data}, of @code{gsmbp_measured}: a struct
## with @code{t}, @code{q}, @code{u}, @code{ud}, @code{tau}, a row for each time.  The rows of all
## times are one system, solved by least squares through QR; the normal equations are not formed.
## What in the data is doubtful is a warning (and a field, @code{doubts}): it names column and size.
##
## Options:
## @table @code
## @item "sigma"
## standard deviation of the noise of each effort (and of the voltage of each motor): one number or
## one for each.  Rows are weighted with 1/sigma, the covariance is that of this noise.
## @item "weights"
## without "sigma": "equal" (default): ordinary least squares, the noise estimated from what
## is left; "residual": weighted by what an ordinary one leaves of each effort
## @item "coulomb", "viscous", "rotor", "offset"
## further columns for the coordinates that are named (true: for all): sign(u), u, ud, 1, with the
## names @code{q1_coulomb}, @dots{}.  Friction that the scene has in its joints is a base parameter
## already.
## @item "motors"
## a struct array, for coordinates whose motor's current and voltage were measured instead of the
## effort: @code{coordinate}, @code{ratio}, @code{current}, @code{voltage} (names of columns in
## @code{data.other}), @code{inductance} (true: with the term L*i').  The effort is ratio*K*i, and v
## = R*i + K*ratio*u are further rows: K, R, L are estimated with the rest.
## @item "decimate"
## n: both sides of the equations, every column of them, pass the same filter without shift
## (Butterworth of order 4, cutoff 0.8/n of half the sampling frequency), then each n-th row is
## kept; one period of the cutoff at both ends is left out.  The covariance counts the noise as
## white, and the motion as well below the cutoff.  Needs times at equal distances.
## @item "fixed"
## names of parameters that keep the values of the model (further ones: 0)
## @item "method"
## "plain" (default): least squares of the efforts; the covariance takes the motion for exact, and
## noise of positions, which derivatives enlarge, biases the estimates.  "total": total least
## squares, of the efforts and the positions as they were measured (@code{data.raw}, or the data
## themselves where they have no such field; speeds, accelerations and filter do not matter).  The
## motion is a spline that is found together with the parameters; the noise of each column follows
## from what is left of it (of the efforts: from "sigma" where it is given), and the covariance is
## that of white noise in efforts and positions.  The times need not be at equal distances; "motors"
## is refused, "decimate" and "weights" are those of the plain estimate
## @end table
##
## @var{e} has the fields
## @table @code
## @item names, units, p, sigma, percent
## the estimates with standard deviations (of 100 p)
## @item covariance
## of p
## @item nominal
## the values in the model (NaN of motor constants)
## @item condition, condition_scaled
## of the (weighted) system as it stands, and with its columns scaled to length 1; the second does
## not depend on units
## @item rms, relative
## of what is left of each effort (voltage); over the rms of the measured one
## @item noise
## the standard deviations that the weights and the covariance took
## @item chi2, dof
## weighted sum of squares of what is left, and rows less parameters: near each other where the
## model and "sigma" fit
## @item residual
## times @code{t} x efforts, measured less estimated
## @item doubts
## sentences: positions outside the limits of a joint; a residual above 0.3 of its signal (with
## "sigma": above 3 sigma); masses, inertias or frictions that no body has; a residual that follows
## the noise of the accelerations; columns that fit better swapped or with the other sign; efforts
## that are late against the motion, or that fit each other better times a factor; speeds that are
## not the rates of the positions
## @item plain, noise_q, motion, intervals
## with "method" "total": the plain estimate (@code{p}, @code{sigma}, @code{covariance}), the noise
## of each position, the motion that was found (@code{t}, @code{q}, @code{u}, @code{ud}) and the
## number of intervals of its spline
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> heavy = gsmbp_set (m, "mb", 2.5, "d", 0.3);
## >> p = gsmbp_plan ("quintic", [0 2 -1], [0 1 2.5]);
## >> r = gsmbp_inverse (heavy, p, 0:0.02:2.5);
## >> data = struct ("t", r.t, "q", r.q, "u", r.u, "ud", r.ud, "tau", r.tau);
## >> e = gsmbp_identify (m, data, "sigma", 0.1);
## >> e.names'
## ans =
## @{
##   [1,1] = bar_hx
##   [1,2] = bar_hy
##   [1,3] = bar_Izz
##   [1,4] = pin_friction
## @}
## >> [e.p, e.sigma, e.nominal]
## ans =
##
##    0.7500   0.0024   0.6000
##   -0.0000   0.0020        0
##    0.2850   0.0029   0.2400
##    0.3000   0.0042   0.1000
## @end example
##
## Errors: a scene with loops, or without REG; data of other sizes; parameters that the data do not
## depend on or do not tell apart (named); an unknown coordinate or parameter; with "total": too few
## times for a smooth motion, motors, no convergence.
## Source: Gautier and Khalil (1990); Swevers et al., IEEE Transactions on Robotics and Automation
## 13 (1997) (weights); Gautier and Briot (2014) (motor constants); Seber and Wild, Nonlinear
## Regression, 1989 (errors in variables).
## @seealso{gsmbp_measured, gsmbp_excite, gsmbp_consistent, gsmbp_adopt, gsmbp_validate}
## @end deftypefn

function e = gsmbp_identify (m, data, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_identify";
  gs.given.check_model (who, m);
  if (ischar (data))
    gs.identify.sound_data (who, m, data, {});   # before the options say what they miss
  endif
  gs.given.check_open_chain (who, m);
  table = {"sigma", [], "numbers"; "weights", "equal", {"equal", "residual"}
           "coulomb", false, "any"; "viscous", false, "any"; "rotor", false, "any"
           "offset", false, "any"; "motors", [], "any"; "fixed", {}, "names"
           "decimate", 1, "whole"; "method", "plain", {"plain", "total"}};
  o = gs.given.call_options (who, table, varargin);
  o.motors = motors_of (who, m, o.motors);
  data = gs.identify.sound_data (who, m, data, {o.motors.coordinate});
  regression = @(d) without (who, gs.identify.regression_rows (who, m, d, o), o.fixed);
  [w, t] = gs.identify.decimate_rows (who, regression (data), data.t, o.decimate);
  [f, noise, scale] = solved (who, w, o, m.sizes.nu + numel (o.motors));
  e = result (m, w, f, noise, scale, numel (t));
  e.t = t;
  if (strcmp (o.method, "total"))
    [e, data] = in_total (who, m, data, e, regression, o);
  endif
  e.options = o;
  e.doubts = gs.identify.list_doubts (m, data, e, regression);
  for said = e.doubts
    warning ("gsmbp:identify", "%s: %s: %s", who, m.name, said{1});
  endfor
endfunction

## by total least squares of what was measured, the PLAIN estimate beside it
function [e, data] = in_total (who, m, data, plain, regression, o)
  if (! isempty (o.motors))
    error (["%s: option method: total takes measured efforts; found motors, whose currents and " ...
            "voltages are measured instead"], who);
  elseif (isfield (data, "raw"))
    [data.t, data.q, data.tau] = deal (data.raw.t, data.raw.q, data.raw.tau);
  endif
  f = gs.identify.total_squares (who, regression, data, o.sigma(:));
  l = gs.identify.least_squares (who, f.w.Y ./ f.noise(f.w.group), f.w.b ./ f.noise(f.w.group), ...
                                 f.w.names);
  [l.p, l.covariance, l.R] = deal (f.p, f.covariance, chol (inv (f.covariance)));
  l.z = l.R * l.p;
  e = result (m, f.w, l, f.noise, 1, numel (data.t));
  [e.t, e.noise_q, e.intervals, data] = deal (data.t, f.noise_q, f.intervals, f.motion);
  e.motion = struct ("t", data.t, "q", data.q, "u", data.u, "ud", data.ud);
  e.plain = struct ("p", plain.p, "sigma", plain.sigma, "covariance", plain.covariance);
endfunction

## units; those of the friction of a joint with one coordinate follow it
function list = units_of (m, w)
  list = w.units(:);
  for k = find (cellfun (@isempty, list))'
    for j = gs.model.json_rows (m.json, "joints")
      c = find (strcmp (m.coordinates, cellstr (j{1}.coordinates){1}));
      if (strcmp ([j{1}.name "_friction"], w.names{k}) && ! isempty (c))
        list{k} = {"N*m*s/rad", "N*s/m"}{1 + strncmp(m.units.coordinates{c}, "m", 1)};
      endif
    endfor
  endfor
endfunction

function list = motors_of (who, m, given)
  list = struct ("coordinate", {}, "ratio", {}, "current", {}, "voltage", {}, "inductance", {});
  if (isempty (given))
    return;
  endif
  if (! (isstruct (given) && all (isfield (given, {"coordinate", "ratio", "current", "voltage"}))))
    error (["%s: option motors: expected a struct array with the fields coordinate, ratio, " ...
            "current, voltage, found %s"], who, gs.text.shown_value (given));
  endif
  for a = given(:)'
    if (! any (strcmp (m.coordinates, a.coordinate)))
      error ("%s: option motors: unknown coordinate %s", who, ...
             gs.text.nearest_word (a.coordinate, m.coordinates(:)'));
    endif
    gs.given.check_kind (who, "option motors: ratio", a.ratio, "number");
    inductance = isfield (a, "inductance") && ! isempty (a.inductance) && a.inductance;
    list(end+1) = struct ("coordinate", a.coordinate, "ratio", a.ratio, "current", a.current, ...
                          "voltage", a.voltage, "inductance", inductance);
  endfor
endfunction

## parameters that are not estimated go to the right with their values
function w = without (who, w, fixed)
  if (isempty (fixed))
    return;
  endif
  for name = cellstr (fixed)(:)'
    k = find (strcmp (w.names, name{1}));
    if (isempty (k))
      error ("%s: option fixed: unknown parameter %s", who, gs.text.nearest_word (name{1}, ...
                                                                                  w.names(:)'));
    elseif (isnan (w.p(k)))
      error ("%s: option fixed: the model has no value of %s", who, name{1});
    endif
    w.b -= w.Y(:,k) * w.p(k);
    w.Y(:,k) = [];
    [w.names(k), w.units(k), w.kind(k), w.p(k)] = deal ([]);
  endfor
endfunction

## ordinary or weighted; NOISE of each group of rows, SCALE of the covariance
function [f, noise, scale] = solved (who, w, o, groups)
  scale = 1;
  if (! isempty (o.sigma))
    noise = o.sigma(:) * w.gain;
    if (isscalar (noise))
      noise = repmat (noise, groups, 1);
    elseif (numel (noise) != groups || any (noise <= 0))
      error ("%s: option sigma: expected one number above 0 or %d, found %s", who, groups, ...
             gs.text.shown_value (o.sigma));
    endif
    f = gs.identify.least_squares (who, w.Y ./ noise(w.group), w.b ./ noise(w.group), w.names);
    return;
  endif
  f = gs.identify.least_squares (who, w.Y, w.b, w.names);
  if (strcmp (o.weights, "equal"))
    scale = max (f.rss / max (1, rows (w.Y) - columns (w.Y)), (eps * norm (w.b) + 1e-150) ^ 2) ...
            * w.estimated ^ 2;
    noise = repmat (sqrt (scale), groups, 1);
    return;
  endif
  share = columns (w.Y) / groups;
  for g = 1:groups
    own = f.residual(w.group == g);
    noise(g,1) = max (w.estimated * sqrt (sumsq (own) / max (1, numel (own) - share)), ...
                      eps * norm (w.b(w.group == g)) + 1e-150);
  endfor
  f = gs.identify.least_squares (who, w.Y ./ noise(w.group), w.b ./ noise(w.group), w.names);
endfunction

function e = result (m, w, f, noise, scale, nt)
  [e.names, e.units, e.p] = deal (w.names(:), units_of (m, w), f.p);
  e.covariance = scale * f.covariance;
  e.sigma = sqrt (diag (e.covariance));
  e.percent = 100 * e.sigma ./ abs (e.p);
  e.nominal = w.p;
  [e.condition, e.condition_scaled] = deal (f.condition, f.condition_scaled);
  e.residual = reshape (w.b - w.Y * f.p, [], 1);
  groups = numel (noise);
  for g = 1:groups
    own = w.group == g;
    e.rms(g,1) = sqrt (sumsq (e.residual(own)) / sum (own));
    e.relative(g,1) = e.rms(g) / sqrt (sumsq (w.measured(own)) / sum (own));
  endfor
  e.noise = noise;
  e.chi2 = sumsq (e.residual ./ noise(w.group));
  e.dof = rows (w.Y) - columns (w.Y);
  rest = zeros (nt, groups);
  for g = 1:groups
    rest(:,g) = e.residual(w.group == g);
  endfor
  e.residual = rest;
  e.kind = w.kind(:);
  [e.R, e.z] = deal (f.R / sqrt (scale), f.z / sqrt (scale));
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! d = struct ("t", 0, "q", 0, "u", 0, "ud", 0, "tau", 0);
%! fail ("gsmbp_identify (m, d)", "has no subroutine REG: derive it with the request");
%! fail ("gsmbp_identify (gsmbp_hand (\"hand_crank\"), d)", "has loops or Euler parameters");
