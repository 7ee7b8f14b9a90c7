## -*- texinfo -*-
## @c category Runs
## @deftypefn  {} {@var{result} =} gsmbp_simulate (@var{m}, @var{x0}, @var{times}, @
## @var{options}, @dots{})
## @deftypefnx {} {[@var{result}, @var{info}] =} gsmbp_simulate (@dots{})
## Simulate a scene; the whole loop runs compiled.
##
## @var{m} is a model of @code{gsmbp_build}, @var{x0} its @var{nx} states at
## @var{times}(1) [s]; the states at all @var{times} (strictly increasing) come back as
## rows.  Steps need not end there: dp853 takes those between its steps from a polynomial of
## order 7 that is as accurate as they are, radau and cvode from their own, each moved onto the
## constraints as the ends of steps are; rk4 and gauss end their steps there.
##
## The start must fulfil the constraints: phi = 0, their rates, Euler parameters of
## length one.  A start that misses one of them by more than 1e-6 (each beside what
## the usual sizes of the states, @code{m.nominal}, make of it) is an error that names
## the rows; @code{gsmbp_assemble} closes a rough guess, with coordinates held if
## wanted.  Below, it is moved onto the constraints, in the same way whatever the
## option "loops" is, and @code{stats.start} tells by how much.  A state where a device
## cannot be (a pressure beyond its supply's, a sensor beyond its range) is an error.
## In a position where the constraints lose rank a run starts with dp853 alone, and if
## the speeds lead out of it on one of the ways that it may go: else it is an error.
## @table @code
## @item "start"
## "check" (default), as above; "project": any start is moved onto the constraints by
## the shortest way in the metric of the mass matrix, which need not be near; devices
## are taken as they are
## @end table
##
## Integration:
## @table @code
## @item "method"
## "dp853" (default): Dormand-Prince 8(5,3) with step control; "rk4": classical
## Runge-Kutta with fixed step; for stiff scenes "radau": collocation of Radau, IIA, of
## the orders 5, 9 and 13 with the exact Jacobian, and "cvode": BDF with it (CVODE of
## SUNDIALS, Debian package libsundials-dev); for long runs that keep their energy
## "gauss": collocation of Gauss with fixed step, of the orders 4, 6 and 8; "auto": dp853 that
## goes on with radau where its steps are found to be bound by stability
## @item "step"
## rk4, gauss: the step [s], default 1e-3 (shortened so that whole steps lead to each
## output time, and to "maxstep"); else the first step, default automatic
## @item "rtol", "atol"
## all but rk4 and gauss: relative tolerance, default 1e-10; absolute tolerance, one number or
## one for each state in its unit, default @code{rtol} times the usual size of
## each state (@code{m.nominal}).  Both are at least ten units of rounding of the
## build's precision (2.2e-15; quad 1.9e-33), a hundred with cvode, @code{atol} times
## @code{m.nominal}: what is below is raised to that, with a warning
## @item "maxstep", "maxsteps"
## the largest step [s], the largest number of steps; 0 (default): no limit
## @item "timeout"
## the wall time [s] after which the run ends with the rows so far; 0 (default): no limit
## @item "maxorder"
## gauss: the order, 4, 6 (default) or 8; radau, auto: the largest order, 5, 9 or 13 (default);
## cvode: 1 to 5 (default).  Above 2 BDF is unstable for fast oscillations with hardly any
## damping: where cvode takes steps as small as these although they have died out, take 2.
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
## @item "index2"
## methods radau and auto in scenes with loops: these in index 2.  At the stages of a step speeds
## are on the constraints instead of accelerations, with multipliers of their own; the end is moved
## onto the constraints.  Mostly as accurate as "projection" in as many steps, which take half as
## long again and more
## @end table
##
## @table @code
## @item "audit"
## an energy [J] that is usual in the scene: powers in and lost are integrated
## with the states (to @code{rtol} and that energy times it), and the result has
## the field @code{audit}, a struct: @code{balance} (a row for each time: energy
## less what came in and was lost [J]), @code{passed} (integral of the moduli of
## these powers [J]), @code{error}, the largest |balance| beside the largest of what
## passed, what is stored, and how far the kinetic energy swings (at @var{times}), the
## rounding of the energies themselves apart; NaN where there is no energy at all (entries without
## @code{energy}).
## What impacts take counts as lost.  Not with feedback.
## @end table
##
## Derivatives by parameters:
## @table @code
## @item "sensitivity"
## names of parameters that the scene was derived for (request @code{sensitivity(m1, k)} of
## @code{gsmbp_fortran}), or of states for their start values: S = dx/dp is integrated with the
## states, S' = A S + P (m.rhp), its errors steer the steps as those of the states do.  The result
## has the structs @code{dx}, @code{dy}, @code{dv} by these names: derivatives of states, outputs
## and inputs at fixed times, a row for each.  Loops: S is moved onto the derivatives of the
## constraints with the states.  At events they jump with the states, as the time of the event
## moves; @code{events.dt}, a struct by these names, has the derivatives of the times of the events.
## Where there is no derivative (the motion only grazes a stop or comes to rest just not; two events
## at one instant whose times move apart; a reset that leaves speeds of a loop open)
## @code{stats.lost}, a struct array with @code{name}, @code{time}, @code{event} and @code{text},
## and a printed warning tell it: from there on the numbers are NaN.  The last row of a run that an
## event ends is at a fixed time, too: the end itself changes by @code{dx + x' dt}.  All methods;
## the ways "projection" and "baumgarte"; constant inputs, piecewise
## polynomials, functions @code{@@(t, x)} in whose text x is not used, planned motions, feedback;
## sampled devices that do not round; not the audit
## @item "dx0"
## the derivatives at the start, @var{nx} rows, a column for each name, default zero; a start value
## by itself, 1, is added
## @item "fixed"
## with loops: the coordinates that keep their place (and their speeds) at the start while a
## parameter changes, default the actuated ones; the others follow so that the loops stay closed.
## The start of a run by other parameters is to be closed with the same coordinates held
## @end table
##
## Inputs (where nothing is said, zero):
## @table @code
## @item "input"
## @var{nv} constants in the order of @code{m.inputs}, or by name,
## @code{@{"u", 2, "motor.v", 12@}} or a struct; a piecewise polynomial with @var{nv} components
## (@code{gsmbp_plan ("table", @dots{})}), which before its first and after its last break holds the
## value that it has there; a function handle
## @code{v = f (t, x)} (called back: slow); or "user": SUBROUTINE GSVIN of
## @code{gsmbp_build}'s option "input"
## @item "motion"
## instead of "input": a planned motion of the actuated coordinates (or of all
## coordinates of an open chain); the inputs that it needs come from the
## inverse model within the compiled loop.  After its last break it is at rest where it is there:
## let it end at rest, else its speed jumps there
## @item "gain", "reference"
## linear state feedback v = v0(t) - K(t)*(x - x0(t)) on top of these: K is
## @var{nv} x @var{nx}, or a piecewise polynomial with @var{nv}*@var{nx}
## components (columns of K one after the other); x0 is a state or a piecewise
## polynomial with @var{nx} components
## @item "limits"
## with "gain": what the actuators can give.  The inputs, v0 and feedback together,
## stop there: one number (each input between its negative and it), @var{nv}
## numbers, or @var{nv} x 2 (lower and upper; Inf: none).  Where a limit is
## reached the equations have a corner; step control finds it.  Held outputs of
## sampled devices and modes have no limits here.
## @item "breaks"
## further times at which an input jumps.  At these, at the breaks of all
## piecewise polynomials and where the scene switches the integration stops and starts again.
## A function is called just before and just behind each, never in the jump itself.
## @end table
##
## Sampled devices (digital controllers, encoders) act within the compiled run: the
## integration meets their instants, k times the period (k = 0, 1, @dots{}), exactly
## and starts again there.  The inputs that are their held outputs are theirs:
## "input" may leave them out, or tell their values before the first sample: constants, or what a
## piecewise polynomial or a function is at @var{times}(1).
## @table @code
## @item "memory"
## their memory at @var{times}(1), @var{nxk} numbers, default as the entries say
## @item "samples"
## false: no record of the instants is kept
## @end table
##
## Events (variant @code{event} of friction and of stops) are met exactly as well,
## with every method; their modes are inputs that belong to the run, "input" may
## leave them out.
## @table @code
## @item "modes"
## the modes at @var{times}(1), one for each of @code{m.events} (0 for an event of the user), as a
## run before has them in its @code{v}; default: as the state says.  Modes that contradict the
## state are an error
## @end table
##
## @var{result} has the fields @code{t}, @code{x} (a row for each time),
## @code{v} (the inputs; from the left where they jump at a break or at an instant of a sampled
## device, at the time of an event as they are behind it), @code{y} (the outputs of the scene, of
## the same side, also where it switches at a time), @code{points} (places of its points and
## frames, three columns each [m]), @code{of} (every column by its name:
## @code{r.of.("tip.x")}, see @code{gsmbp_names}), @code{unique} (which outputs
## the motion determines: not all reactions are in scenes with more constraints than their motion
## needs; @code{m.unique} tells it of every scene), @code{options} (a struct of
## those that were given) and @code{stats}:
## @table @code
## @item calls, accepted, rejected, repeated, projections, seconds
## calls of the right-hand side, steps (@code{repeated}: those that could not
## be moved onto the constraints, or only by a jump), compiled run [s]
## @item start
## a struct: the largest @code{residual} of the constraints in @var{x0} (beside
## @code{m.nominal}), its @code{row}, by how much the start was @code{moved} onto them at
## most (beside @code{m.nominal}), and in which @code{state}; 0 and empty where it fulfilled them
## @item drift
## a struct: @code{phi} and @code{phidot}, the largest |phi|, |phidot| after any step,
## @code{phi_at} and @code{phidot_at}, when [s]; @code{before_projection}, the largest
## |phi| (or error of the length of Euler parameters) before the state was moved
## @item rank_losses, rank_loss_times
## calls where the constraints were dependent (all, if the scene has redundant
## ones); first and last time [s]
## @item singular_positions, singular_times
## positions passed where the constraints lose rank (dead centres, change
## points: the mechanism may go on in more than one way), as the pivots after
## the steps and within long ones show it (of several within one step: one); first
## and last time [s].  This is a printed warning too.  Only dp853 looks ahead for
## such positions: how accurate the others pass one is left to chance.
## @item loose
## steps close to such positions whose estimated error is above the tolerance: there
## it could not be kept.  A step through one keeps some 1e-13 at best.  The others:
## steps that end where the least pivot is below a hundredth of its largest value.
## They are a printed warning even where no such position was passed.
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
## @item stiff
## a struct: where steps of an explicit method were found to be bound by
## stability, not by accuracy, @code{time} [s] (NaN: nowhere), @code{eigenvalue}
## (its modulus [1/s]), @code{state} (where it shows most), @code{step} [s].
## This is a printed warning too.
## @item margins
## a struct array, empty if all is well: margins of devices (a stroke, a pressure) that are
## not kept at some of @var{times}: @code{text}, @code{time} of the first one [s],
## @code{least} value, @code{said}, a sentence with the states and parameters that it is made of.
## This is a printed warning too.  Only @var{times} are looked at, not what is between them:
## take them as close as the motion changes.
## @item method, jacobians, newton
## the method of the last step; radau, cvode: evaluations of the Jacobian, iterations
## of Newton's method
## @item rtol, atol
## the tolerances that were kept to; NaN of rk4 and gauss, which have none
## @item smallest_step, largest_step, reached
## of the accepted steps [s]; the time to which the run came [s]
## @item events, instants
## how many events and instants of sampled devices there were, in scenes that have such; more
## events than the 10000 that the result has are a printed warning too (@code{gsmbp:events})
## @item held
## with controllers of @code{gsmbp_model_control} through loops or drives: a struct array of their
## @code{name}, how many @code{samples} had no command (the inputs stayed as they were, because the
## loops do not close at what is measured or the drives cannot give the motion), the time of the
## @code{first} [s].  This is a printed warning too.
## @end table
## With sampled devices also @code{memory} (theirs at the end; what is on its way to an output then
## is lost) and @code{samples}, a struct with a row for each instant: @code{t} [s],
## @code{xk} (memory), @code{v} (inputs), both after it.
## With events also @code{events}, a struct with a row for each (10000 at most):
## @code{t} [s], @code{number} (of @code{m.events}), @code{name} and @code{device} (both the name of
## the event: of the device that has it, or that of the user), @code{mode} (after it), @code{loss}
## (of mechanical energy at an impact [J]), @code{before} and @code{after} (states).
## If the run fails it is an error, unless @var{info} is taken: then the rows
## end where it failed.
##
## Ctrl-C ends the run, and not what called it (a second one within half a second does), and so does
## "timeout": no error.  The rows so far are those of the whole run, bit by bit;
## @code{stats.stopped} is "interrupted" or "timeout" (else ""), @var{info} is 9 or 10, and where
## it is not taken a warning (@code{gsmbp:stopped}) says so.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_simulate (m, m.initial, [0; 0.1; 0.2], "input", 12);
## >> [r.t, r.x(:,1:3)]
## ans =
##
##         0        0        0   0.7000
##    0.1000   0.2123  -0.2966   0.6937
##    0.2000   0.4464  -0.6199   0.6729
## @end example
##
## Errors: a start that does not fulfil the constraints, or a state where a
## device cannot be; an argument or option that is unknown, of another size or
## not finite; a run that fails, unless info is taken.
## Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I
## (dp853, rk4); II, and J. Comput. Appl. Math. 111, 1999 (radau); SUNDIALS (cvode);
## the constraint methods and the rest are own, as share/engine/core describes them.
## @seealso{gsmbp_build, gsmbp_plan, gsmbp_assemble, gsmbp_inverse}
## @end deftypefn

function [result, info] = gsmbp_simulate (m, x0, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_simulate";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x0", x0, "times", times);
  o = gs.given.call_options (who, gs.run.option_table (), varargin);
  p = gs.run.plan_run (who, m, x0, times, o);
  found = m.module ("run", m.cst, p.given);
  gs.run.refuse_run (who, m, found);
  if (isfield (m.par, "loop_method") && m.par.loop_method != found.loop_method)
    m = gsmbp_set (m, "loop_method", found.loop_method);
  endif
  result = result_of (who, m, o, found, varargin);
  if (! isempty (p.carried.names))
    result = gs.linear.run_derivatives (m, result, p.carried.names, found);
  endif
  tell_warnings (who, m, result, found);
  info = found.info;
  at = sprintf ("at t = %.9g of %.9g s", found.stats.reached, p.times(end));
  result.stats.stopped = gs.run.stopped_word (who, m, info, at, nargout < 2);
  if (found.ended > 0)
    result.stats.stopped = ["event " m.events(found.ended).name];
  endif
  if (info != 0 && nargout < 2 && isempty (result.stats.stopped))
    [text, id] = gs.run.failure_text (m, found.text, info, found.stats, last_state (m, found));
    error (id, "%s: %s: %s", who, m.name, text);
  endif
endfunction

## what the module has found, by the names of the result
function result = result_of (who, m, o, found, options)
  nx = m.sizes.nx;
  x = found.x(:,1:found.rows)';
  result = struct ("t", found.t, "x", x(:,1:nx), "v", found.v(:,1:found.rows)');
  [names, given] = gs.given.name_value_pairs (who, "option", options);
  result.options = cell2struct (given(:), names(:), 1);
  result.y = found.y';
  result.unique = m.unique.outputs;
  s.start = rmfield (found.start, "verdict");
  s.start.state = [{""}; m.states(:)]{1 + found.start.state};
  if (! isempty (m.controllers))
    result.memory = found.memory;
    record = found.samples';
    result.samples = struct ("t", record(:,1), "xk", record(:,2:1+m.sizes.nxk), "v", ...
                             record(:,2+m.sizes.nxk:end));
    s.instants = found.instants;
    s.held = gs.run.held_samples (m, result, o.memory);
  endif
  if (! isempty (m.events))
    result.events = gs.events.event_list (m, found.events);
    s.events = found.happened;
  endif
  if (! isempty (o.audit))
    result.audit = gs.run.energy_audit (m, result, x(:,nx+1:end));
  endif
  result.stats = gs.run.named_statistics (s, m, result, found.method, found.stats);
  result.stats.seconds = found.seconds;
  [result.stats.rtol, result.stats.atol] = deal (found.rtol, found.atol(1:nx));
  row = gs.run.method_row (found.method);
  if (row.fixed)
    [result.stats.rtol, result.stats.atol] = deal (NaN, NaN (nx, 1));
  endif
  result = gs.model.named_results (m, result);
endfunction

function tell_warnings (who, m, result, found)
  listed = 0;
  if (! isempty (m.events))
    listed = columns (found.events);
  endif
  gs.run.warn_of (who, m, result.stats, listed);
  if (! isempty (m.events) && ! isempty (result.t))
    run = struct ("run", 1, "method", result.stats.method, "atol", found.atol, "happened", ...
                  unique (result.events.number), "t", result.t(end), "x", result.x(end,:), ...
                  "v", result.v(end,:));
    gs.events.sharp_friction (who, m, gs.events.sharp_ports (m, run), 1);
  endif
endfunction

## where a run ended before its time
function last = last_state (m, found)
  last = [];
  k = found.rows + 1;
  if (k <= columns (found.x) && all (isfinite ([found.x(:,k); found.v(:,k)])))
    last = struct ("x", found.x(1:m.sizes.nx,k), "v", found.v(:,k));
  endif
endfunction

%!shared m, c
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
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
%!test <a stiff motor: BDF with a hundredth of the calls>
%! if (! gsmbp_has_sundials ())
%!   return;
%! endif
%! f = gsmbp_set (m, "L_a", 1e-5);
%! warning ("off", "gsmbp:stiff", "local");
%! r = gsmbp_simulate (f, [0.2 0 0], [0 1], "input", 3, "method", "cvode");
%! e = gsmbp_simulate (f, [0.2 0 0], [0 1], "input", 3);
%! assert (r.x, e.x, 1e-8);
%! assert (r.stats.calls < 0.01 * e.stats.calls && strcmp (e.stats.stiff.state, "drive.i"));
%!test <inputs are told from the left where they jump, at the end too>
%! table = gsmbp_plan ("table", [0 0.5 1], [0 5 7], 0);
%! for method = {"dp853", "rk4", "radau", "cvode"}(1:3 + gsmbp_has_sundials ())
%!   r = gsmbp_simulate (m, [0 0 0], [0 0.25 0.5 0.75 1], "input", table, "method", method{1});
%!   assert (r.v', [0 0 0 5 5]);
%! endfor
%!test <outside of its breaks a piecewise polynomial holds its ends>
%! for method = {"dp853", "rk4", "radau"}
%!   r = gsmbp_simulate (m, [0 0 0], [0 0.5 1 1.5], "input", mkpp ([0.5 1], [2 1]), "method", ...
%!                       method{1});
%!   assert (r.v', [1 1 2 2], 1e-15);
%! endfor
%!error <argument x0: expected 3 numbers> gsmbp_simulate (m, 1, [0 1])
%!error <argument x0\(1\), q is not finite: NaN> gsmbp_simulate (m, [NaN 0 0], [0 1])
%!error <strictly increasing> gsmbp_simulate (m, [0 0 0], [0 1 1])
%!error <expected one of "dp853", "rk4", "cvode", "radau", "gauss", "auto", found "euler">
%! gsmbp_simulate (m, [0 0 0], [0 1], "method", "euler")
%!test <six words, of which hand_crank knows three>
%! x0 = gsmbp_assemble (c, [0.3 -0.1 0.7 12 0 0]);
%! for word = {"baumgarte", "projection", "partitioning"}
%!   r = gsmbp_simulate (c, x0, [0 0.5], "loops", word{1});
%!   assert (r.x(2,:), gsmbp_simulate (c, x0, [0 0.5], "rtol", 1e-13).x(2,:), 1e-7);
%! endfor
%!error <derive the scene again> gsmbp_simulate (c, c.initial, [0 1], "loops", "svd")
%!error <option loops must be one of baumgarte>
%! gsmbp_simulate (c, c.initial, [0 1], "loops", "none")
%!error <not both> gsmbp_simulate (c, c.initial, [0 1], "loops", "svd", "projection", true)
%!error <needs the subroutine PRJ> gsmbp_simulate (m, [0 0 0], [0 1], "projection", true)
%!test <a feedback that stops at its limits: full voltage until late, and it arrives>
%! K = [400, 10, 0];
%! r = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "gain", K, "reference", [0.5; 0; 0], "limits", 12);
%! assert (max (abs (r.v)), 12);
%! free = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "gain", K, "reference", [0.5; 0; 0]);
%! assert (max (abs (free.v)) > 100 && abs (free.x(end,1) - r.x(end,1)) < 1e-6);
%! e = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "input", ...
%!                     @(t, x) min (12, max (-12, -K * (x - [0.5; 0; 0]))));
%! assert (r.x, e.x, 1e-8);
%! if (gsmbp_has_sundials ())
%!   c = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "gain", K, "reference", [0.5; 0; 0], "limits", ...
%!                       [-12 12], "method", "cvode");
%!   assert (r.x, c.x, 1e-5);
%! endif
%! e = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "gain", K, "reference", [0.5; 0; 0], "limits", ...
%!                     [-Inf Inf]);
%! assert (e.x, free.x);
%! e = gsmbp_simulate (m, [0 0 0], 0:0.01:3, "gain", K, "reference", [0.5; 0; 0], "limits", ...
%!                     [-Inf 12]);
%! assert (max (e.v), 12);
%!error <needs option gain> gsmbp_simulate (m, [0 0 0], [0 1], "limits", 12)
%!error <the lower limit must be below>
%! gsmbp_simulate (m, [0 0 0], [0 1], "gain", [1 0 0], "reference", [0 0 0], "limits", [1 -1])
%!error <expected 1, 1 or 1 x 2 numbers>
%! gsmbp_simulate (m, [0 0 0], [0 1], "gain", [1 0 0], "reference", [0 0 0], "limits", [1 2 3])
%!error <expected real numbers>
%! gsmbp_simulate (m, [0 0 0], [0 1], "gain", [1 0 0], "reference", [0 0 0], "limits", NaN)
%!error <maxstep: 10 s in steps of 1e-09 s are 1e\+10 steps of rk4; expected 2e\+09 at the most>
%! gsmbp_simulate (m, [0 0 0], [0 10], "method", "rk4", "maxstep", 1e-9)
%!error <in steps of 1e-30 s are 1e\+31 steps of dp853; expected 1e\+15 at the most>
%! gsmbp_simulate (m, [0 0 0], [0 10], "maxstep", 1e-30)
%!error <3e\+06 s in steps of 0.001 s are 3e\+09 steps of rk4; expected 2e\+09 at the most>
%! gsmbp_simulate (m, [0 0 0], [0 3e6], "method", "rk4", "timeout", 1)
%!error <input: expected 1 finite> gsmbp_simulate (m, [0 0 0], [0 1], "input", [1 2])
