## -*- texinfo -*-
## @deftypefn  {} {@var{result} =} gsmbp_simulate (@var{m}, @var{x0}, @var{times}, @var{option}, @var{value}, @dots{})
## @deftypefnx {} {[@var{result}, @var{info}] =} gsmbp_simulate (@dots{})
## Simulate a scene; the whole loop runs compiled.
##
## @var{m} is a model of @code{gsmbp_build}, @var{x0} its @var{nx} states at
## @var{times}(1) [s]; the states at all @var{times} (strictly increasing, each
## met exactly) come back as rows.
##
## Integration:
## @table @code
## @item "method"
## "dp853" (default): Dormand-Prince 8(5,3) with step control, or "rk4":
## classical Runge-Kutta with fixed step
## @item "step"
## rk4: the step [s], default 1e-3 (shortened so that whole steps lead to each
## output time); dp853: the first step, default automatic
## @item "rtol", "atol"
## dp853: relative tolerance, default 1e-10; absolute tolerance, one number or
## one for each state in its unit, default @code{rtol}
## @item "maxstep", "maxsteps"
## the largest step [s], the largest number of steps; 0 (default): no limit
## @item "loops"
## the way of the loops (and of Euler parameters), a word of the table below
## @item "projection"
## true and false are other words for "loops", "projection" and "baumgarte"
## @item "drift"
## false: drift and rank of the constraints are not watched.  This is faster, but
## singular positions are then neither reported nor taken with care, and
## redundant constraints need the way "partitioning".
## @end table
##
## The ways of the loops:
## @table @code
## @item "projection"
## (default) equations with multipliers; the state is moved onto the
## constraints after every step
## @item "baumgarte"
## equations with multipliers; drift is left to Baumgarte's terms, whose
## constants are parameters (@code{gsmbp_set}).  Euler parameters are not
## normalized in this way.
## @item "partitioning"
## coordinate partitioning: before every call of the right-hand side the
## dependent coordinates and speeds are computed from the independent ones,
## which are chosen anew when they become ill-conditioned
## @item "nullspace"
## accelerations without multipliers in the null space of the constraints (QR);
## the state is moved onto the constraints after every step
## @item "svd"
## the same by the zero-eigenvalue theorem (singular values)
## @item "kane"
## Kane's equations with dependent speeds; these are computed from the
## independent ones before every call, positions are moved onto the
## constraints after every step
## @end table
##
## Inputs (where nothing is said, zero):
## @table @code
## @item "input"
## @var{nv} constants; a piecewise polynomial with @var{nv} components
## (@code{gsmbp_plan ("table", @dots{})}); a function handle
## @code{v = f (t, x)} (called back: slow); or "user": SUBROUTINE GSVIN of
## @code{gsmbp_build}'s option "input"
## @item "motion"
## instead of "input": a planned motion of the actuated coordinates (or of all
## coordinates of an open chain); the inputs that it needs come from the
## inverse model within the compiled loop
## @item "gain", "reference"
## linear state feedback v = v0(t) - K(t)*(x - x0(t)) on top of these: K is
## @var{nv} x @var{nx}, or a piecewise polynomial with @var{nv}*@var{nx}
## components (columns of K one after the other); x0 is a state or a piecewise
## polynomial with @var{nx} components
## @item "breaks"
## further times at which an input jumps.  At these and at the breaks of all
## piecewise polynomials the integration stops and starts again.
## @end table
##
## @var{result} has the fields @code{t}, @code{x} (a row for each time),
## @code{v} (the inputs; from the left where they jump) and @code{stats}:
## @table @code
## @item calls, accepted, rejected, repeated, projections, seconds
## calls of the right-hand side, steps (@code{repeated}: those that could not
## be moved onto the constraints, or only by a jump), compiled run [s]
## @item drift
## a struct: largest |phi|, |phidot| after any step, and when
## @item rank_losses, rank_loss_times
## calls where the constraints were dependent (all, if the scene has redundant
## ones); first and last time [s]
## @item singular_positions, singular_times
## positions passed where the constraints lose rank (dead centres, change
## points: the mechanism may go on in more than one way), as the pivots after
## the steps show it; first and last time [s].  This is a printed warning too.
## @item least_pivot, least_pivot_at
## how near it came: the least pivot of the constraint Jacobian beside the
## largest, and when [s]
## @item angle_singularities, angle_times
## calls within 0.05 rad of a singularity of orientation angles; first and last time [s].
## This is a printed warning too: Euler parameters have no singularity.
## @item partition_changes
## how often other independent speeds were chosen (also where another way
## borrows from "partitioning": close to singular positions and where
## constraints are redundant)
## @end table
## If the run fails it is an error, unless @var{info} is taken: then the rows
## end where it failed.
## @seealso{gsmbp_build, gsmbp_plan, gsmbp_assemble, gsmbp_inverse}
## @end deftypefn

function [result, info] = gsmbp_simulate (m, x0, times, varargin)
  if (nargin < 3 || ! isstruct (m) || ! isfield (m, "module"))
    print_usage ();
  endif
  who = "gsmbp_simulate";
  d = m.sizes;
  has = @(name) any (strcmp (m.subroutines, name));
  defaults = struct ("method", "dp853", "step", [], "rtol", 1e-10, "atol", [], "maxstep", 0, "maxsteps", 0, "loops", "", "projection", [],
                     "drift", has ("con") && d.nlam > 0, "input", [], "motion", [], "gain", [], "reference", [], "breaks", []);
  o = gsmbp__options (who, defaults, varargin);
  times = gsmbp__times (who, times);
  [m, way] = loops (who, o, m);
  [iopt, ropt, atol] = integration (who, o, d, m, way);
  [ip, rp, breaks, callback] = inputs (who, o, m);
  t0 = times(1);
  breaks = unique ([breaks, o.breaks(:)']);
  breaks = breaks(breaks > t0 & breaks < times(end));
  guess = zeros (d.nu, 1);
  if (d.nq == d.nu && numel (x0) == d.nx)
    guess = x0(1:d.nq);
  endif
  [x, v, counts, values, info, seconds] = m.module ("sim", m.cst, t0, x0, times, breaks, [numel(times), numel(breaks)], iopt, ropt, atol, ip, rp, guess, callback);

  reached = counts(5);
  result.t = times(1:reached)';
  result.x = x(:,1:reached)';
  result.v = v(:,1:reached)';
  s.seconds = seconds;
  s.calls = counts(1);
  s.accepted = counts(2);
  s.rejected = counts(3);
  s.repeated = counts(12);
  s.projections = counts(4);
  s.rank_losses = counts(8);
  s.rank_loss_times = values(10:11)';
  s.singular_positions = counts(11);
  s.singular_times = values(16:17)';
  s.least_pivot = values(14);
  s.least_pivot_at = values(15);
  s.angle_singularities = counts(9);
  s.angle_times = values(12:13)';
  s.partition_changes = counts(10);
  s.smallest_step = values(6);
  s.largest_step = values(7);
  s.drift = struct ("phi", values(1), "phidot", values(2), "phi_at", values(3), "phidot_at", values(4), "before_projection", values(5));
  s.reached = values(8);
  result.stats = s;
  warn (who, m, s);
  if (info != 0 && nargout < 2)
    error ("gsmbp:info", "%s: %s: %s", who, m.name, failure (info, counts, values));
  endif
endfunction

## the way of the loops: its number, and the model with its parameter loop_method
function [m, way] = loops (who, o, m)
  words = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"};
  d = m.sizes;
  has = @(name) any (strcmp (m.subroutines, name));
  euler = d.nq > d.nu;
  word = o.loops;
  if (isempty (word))
    word = words{1 + (has ("prj") && (d.nlam > 0 || euler))};
    if (! isempty (o.projection))
      word = words{1 + logical(o.projection)};
    endif
  elseif (! isempty (o.projection))
    error ("%s: give \"loops\" or \"projection\", not both", who);
  endif
  way = find (strcmp (word, words));
  if (isempty (way))
    error ("%s: option loops must be one of %s; found: %s", who, strjoin (words, ", "), strtrim (disp (word)));
  endif
  if (d.nlam == 0 && isempty (o.projection))
    way = 1 + (way > 1 && euler);   # nothing but Euler parameters to look after
  endif
  method = max (1, way - 2);
  if (isfield (m.par, "loop_method"))
    if (m.par.loop_method != method)
      m = gsmbp_set (m, "loop_method", method);
    endif
  elseif (method > 1)
    error ("%s: %s was derived without the ways nullspace, svd and kane (it has no parameter loop_method): derive the scene again", who, m.name);
  endif
  needs = {{}, {"prj"}, {"con", "kin", {"prj"}{ones (1, euler)}}, {"prj"}, {"prj"}, {"con", "kin", "prj"}}{way};
  for name = needs
    if (! has (name{1}))
      error ("%s: the way \"%s\" needs the subroutine %s, which %s was emitted without", who, words{way}, toupper (name{1}), m.name);
    endif
  endfor
endfunction

## what the result does not show by itself
function warn (who, m, s)
  if (s.singular_positions > 0)
    warning ("gsmbp:singular", "%s: %s passed %d position%s where its constraints lose rank, the first at t = %.6g s: it may go on in more than one way there", who, m.name,
             s.singular_positions, {"", "s"}{1 + (s.singular_positions > 1)}, s.singular_times(1));
  endif
  if (s.angle_singularities > 0)
    joints = "";
    if (! isempty (m.angles))
      joints = [" of " strjoin(m.angles(:)', ", ")];
    endif
    warning ("gsmbp:angles", "%s: %s came within 0.05 rad of a singularity of its orientation angles%s at t = %.6g s: choose another sequence of axes or Euler parameters", who, m.name,
             joints, s.angle_times(1));
  endif
endfunction

function [iopt, ropt, atol] = integration (who, o, d, m, way)
  methods = struct ("rk4", 4, "dp853", 8);
  if (! (ischar (o.method) && isfield (methods, o.method)))
    error ("%s: method must be \"rk4\" or \"dp853\"", who);
  endif
  rk4 = strcmp (o.method, "rk4");
  if (isempty (o.step))
    o.step = 1e-3 * rk4;
  endif
  for name = {"step", "rtol", "maxstep", "maxsteps"}
    value = o.(name{1});
    if (! (isnumeric (value) && isscalar (value) && isfinite (value) && value >= 0))
      error ("%s: option %s must be a number >= 0", who, name{1});
    endif
  endfor
  if (rk4 && o.step == 0 || ! rk4 && o.rtol == 0)
    error ("%s: option %s must be above 0", who, {"rtol", "step"}{1 + rk4});
  endif
  atol = o.atol;
  if (isempty (atol))
    atol = o.rtol;
  endif
  if (isscalar (atol))
    atol = repmat (atol, d.nx, 1);
  endif
  if (numel (atol) != d.nx || ! all (atol(:) >= 0))
    error ("%s: option atol: expected one number or %d numbers, all >= 0", who, d.nx);
  endif
  if (o.drift && ! any (strcmp (m.subroutines, "con")))
    error ("%s: option drift needs the subroutine CON, which %s was emitted without", who, m.name);
  endif
  iopt = [methods.(o.method), way, logical(o.drift), o.maxsteps, 0, 0, m.speed_rows'];
  ropt = [o.step, o.rtol, o.maxstep];
endfunction

## the arrays IP, RP of GSINP, the breaks, the function to call back
function [ip, rp, breaks, callback] = inputs (who, o, m)
  d = m.sizes;
  ip = zeros (1, 30);
  ip(4) = m.order;
  rp = breaks = [];
  callback = 0;
  if (! isempty (o.motion))
    if (! isempty (o.input))
      error ("%s: give \"input\" or \"motion\", not both", who);
    endif
    [pp, planned] = gsmbp__motion (who, m, o.motion);
    ip(1) = 2;
    ip(3) = d.nlam > 0 && numel (planned) < d.nu;
    ip(5) = numel (planned);
    ip(30 + (1:numel (planned))) = planned;
    [ip, rp, breaks] = put (ip, rp, breaks, 10, pp);
  elseif (isempty (o.input))
    ip(9) = 1;
    rp = zeros (1, d.nv);
  elseif (isstruct (o.input))
    ip(1) = 1;
    [ip, rp, breaks] = put (ip, rp, breaks, 6, gsmbp__pp (who, o.input, d.nv, "the input"));
  elseif (is_function_handle (o.input))
    ip(1) = 3;
    callback = o.input;
  elseif (ischar (o.input))
    if (! strcmp (o.input, "user"))
      error ("%s: input \"%s\" is not known; only \"user\" is a word here", who, o.input);
    endif
    ip(1) = 3;
  else
    constants = o.input;
    if (! (isnumeric (constants) && numel (constants) == d.nv && all (isfinite (constants(:)))))
      error ("%s: input: expected %d finite numbers, found %s", who, d.nv, disp (constants)(1:end-1));
    endif
    ip(9) = 1;
    rp = double (constants(:)');
  endif

  if (! isempty (o.gain))
    if (isempty (o.reference))
      error ("%s: a gain needs a reference, the state about which it acts", who);
    endif
    ip(2) = 1;
    [ip, rp, breaks] = put (ip, rp, breaks, 14, as_pp (who, o.reference, [d.nx 1], "the reference"));
    [ip, rp, breaks] = put (ip, rp, breaks, 18, as_pp (who, o.gain, [d.nv d.nx], "the gain"));
  endif
endfunction

## a piecewise polynomial into RP, its description into IP(PLACE:PLACE+3)
function [ip, rp, breaks] = put (ip, rp, breaks, place, pp)
  ip(place:place+3) = [pp.pieces, pp.order, numel(rp) + 1, numel(rp) + numel(pp.breaks) + 1];
  rp = [rp, pp.breaks(:)', pp.coefs(:)'];
  breaks = [breaks, pp.breaks(2:end-1)(:)'];
endfunction

## a constant array as a piecewise polynomial of one piece
function pp = as_pp (who, value, dims, what)
  if (isstruct (value))
    pp = gsmbp__pp (who, value, prod (dims), what);
  elseif (isnumeric (value) && (isequal (size (value), dims) || (dims(2) == 1 && isequal (size (value), dims([2 1])))) && all (isfinite (value(:))))
    pp = mkpp ([0 1], double (value(:)), numel (value));
  else
    error ("%s: %s: expected %d x %d finite numbers or a piecewise polynomial", who, what, dims);
  endif
endfunction

function text = failure (info, counts, values)
  at = sprintf ("at t = %.9g s", values(8));
  switch (info)
    case 1
      text = ["more steps than option maxsteps allows, " at];
    case 2
      text = ["the step became too small " at ": a singularity, or too small a tolerance"];
    case 3
      routine = {"the inputs", "RHS", "PRJ", "CON", "the computation of the dependent coordinates"}{counts(7)};
      text = sprintf ("%s failed with INFO = %d %s", routine, counts(6), at);
      if (any (counts(7) == [3, 5]) && counts(6) == 3)
        text = [text ": no position that closes the loops was found nearby; the mechanism may be at the end of its range"];
      endif
    case 4
      text = ["the state is no longer finite " at ": take smaller steps"];
    otherwise
      text = sprintf ("GSSIM: INFO = %d", info);
  endswitch
endfunction

%!shared m, c
%! addpath (fullfile (fileparts (fileparts (which ("gsmbp_build"))), "tests", "octave"));
%! m = gsmbp_hand ("motor_pendulum");
%! c = gsmbp_hand ("hand_crank");
%!test <a planned motion through the inverse model comes back>
%! plan = gsmbp_plan ("septic", [0 2], [0 1]);
%! r = gsmbp_simulate (m, [0 0 0], [0 0.5 1], "motion", plan, "rtol", 1e-12);
%! assert (r.x(:,1:2), [0 0; 1 35/8*0.5; 2 0](:,1:2), [Inf Inf; 1e-9 Inf; 1e-9 1e-9]);
%!test <projection keeps the loop closed>
%! x0 = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0]);
%! r = gsmbp_simulate (c, x0, [0 1], "method", "rk4", "step", 1e-3);
%! assert (r.stats.drift.phi < 1e-12 && r.stats.projections == 1001);
%!error <argument x0: expected 3 numbers> gsmbp_simulate (m, 1, [0 1])
%!error <argument x0\(1\) is not finite> gsmbp_simulate (m, [NaN 0 0], [0 1])
%!error <strictly increasing> gsmbp_simulate (m, [0 0 0], [0 1 1])
%!error <method must be> gsmbp_simulate (m, [0 0 0], [0 1], "method", "euler")
%!test <six words, of which hand_crank knows three>
%! x0 = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0]);
%! for word = {"baumgarte", "projection", "partitioning"}
%!   r = gsmbp_simulate (c, x0, [0 0.5], "loops", word{1});
%!   assert (r.x(2,:), gsmbp_simulate (c, x0, [0 0.5], "rtol", 1e-13).x(2,:), 1e-7);
%! endfor
%!error <derive the scene again> gsmbp_simulate (c, c.initial, [0 1], "loops", "svd")
%!error <option loops must be one of baumgarte> gsmbp_simulate (c, c.initial, [0 1], "loops", "none")
%!error <not both> gsmbp_simulate (c, c.initial, [0 1], "loops", "svd", "projection", true)
%!error <needs the subroutine PRJ> gsmbp_simulate (m, [0 0 0], [0 1], "projection", true)
%!error <input: expected 1 finite> gsmbp_simulate (m, [0 0 0], [0 1], "input", [1 2])
