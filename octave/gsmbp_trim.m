## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{r} =} gsmbp_trim (@var{m}, @var{x}, @var{v})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "hold", @var{names}, "free", @var{inputs})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "time", @var{t}, "tolerance", @var{tol})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "steady", @var{names})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "margins", @var{word})
## An equilibrium of a scene: a state at rest, with loops closed, in which
## nothing is accelerated; or a steady motion.
##
## From the guess @var{x} (@var{nx} states, or the @var{nq} coordinates: the
## states of the devices then start as the scene says) and the inputs @var{v}
## (@var{nv}, zeros by default) of the model @var{m} all coordinates and states
## of devices are adjusted by Newton's method with the exact Jacobians; speeds
## are zero.  States named in "hold" keep their value, inputs named in "free"
## are adjusted as well.  What a sampled device holds is an input here.
## A scene with events has a Jacobian with the request sensitivity alone, at the modes that
## @var{v} holds (0: a port holds, the default; -1 or 1: it slips); else it is refused.
##
## With "steady" the coordinates @var{names} run on at the constant speeds that @var{x} has for
## them: a motor at speed, a wheel that rolls straight on or in a circle, a top's precession.
## Coordinates that a motion of the scene drives (@code{motion = W*t}) run on with the time.  The
## other coordinates are at rest, but for those on which nothing depends (the place of what rolls).
## Speeds named in "free" are adjusted as well, "hold" may name a coordinate that would be.  The
## independent speeds are constant, dependent ones follow; that it stays so while the coordinates
## run on is checked.
##
## States count by their usual sizes (@code{m.nominal}), and the iteration goes
## on as long as the equations gain digits.  An equilibrium is one where every
## rate is below @var{tol} (default 1e-9) times the usual size of its state in a
## second, every constraint below @var{tol}, or where rounding of the terms
## hides the rest.
##
## @var{r} has the fields @code{x}, @code{v}, @code{running} (names of coordinates that run),
## @code{ud} (accelerations that are left, zero to rounding; of steady motions those of dependent
## speeds need not be), @code{lambda} (multipliers), @code{unique} (which
## of them the equilibrium determines), @code{phi},
## @code{residual} (the largest of rates and constraints, of these sizes),
## @code{way} ("newton", "levenberg" or "transient": what was needed) and
## @code{indifferent}: names of the states and free inputs that can be moved
## without leaving the equilibrium; it is empty for one that stands alone.
##
## An equilibrium that is not found is an error that names the equations that
## do not vanish, and inputs that could make them; so is a constraint that
## moves with time, and one in which a margin of a device is below 0 (a cylinder out of
## its stroke, a pressure below the tank's; @code{m.state_margins}), unless "margins",
## "ignore" is given.  One that holds at the time @var{t} only (default 0) is a
## warning.  Of several equilibria the one near the guess is found.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_trim (m, m.initial, 0, "hold", "q1", "free", "motor.v");
## >> r.v, r.residual < 1e-12
## ans = 1.0326
## ans = 1
## @end example
##
## Errors: no equilibrium or steady motion is found (the equations that do not vanish are
## named); a derivative that is not finite; one that is steady at an instant alone; a
## constraint that moves with time; a margin of a device below 0; an unknown name in "hold" or
## "free".
## Source: own: Newton's method with the exact Jacobians, Levenberg's and a
## transient where it fails.
## @seealso{gsmbp_linear, gsmbp_assemble}
## @end deftypefn

function r = gsmbp_trim (m, x, v, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_trim", m);
  if (nargin < 3)
    v = [];
  endif
  gs.given.refuse_words ("gsmbp_trim", "x", x, "v", v);
  table = {"hold", {}, "names"
           "free", {}, "names"
           "steady", {}, "names"
           "time", 0, "number"
           "tolerance", 1e-9, "tolerance"
           "margins", "check", {"check", "ignore"}};
  o = gs.given.call_options ("gsmbp_trim", table, varargin);
  [x, v] = guess (m, x, v, o);
  at = gs.linear.state_place (m, o.time, x, v);
  asked = what_is_asked (m, o);
  [verdict, text, x, v, residual, way, running, moved, later] = m.module ("trim", at{:}, asked{:});
  gs.linear.heed_verdict ("gsmbp_trim", m, verdict, text);
  if (! isempty (later))
    warning ("gsmbp:trim", "gsmbp_trim: %s: %s", m.name, later);
  endif
  r = result (m, o.time, x, v);
  [r.residual, r.way] = deal (residual, {"newton", "levenberg", "transient"}{way});
  r.running = m.coordinates(running)(:)';
  r.indifferent = [m.states(:); m.inputs(:)](moved)(:)';
  loose = gs.start.warn_of_rank ("gsmbp_trim", m, o.time, x, "singular_rest");
  r.unique = (m.unique.multipliers & ! loose)';
endfunction

## the guess: all states and inputs
function [x, v] = guess (m, x, v, o)
  d = m.sizes;
  if (! any (strcmp (m.subroutines, "jac")))
    gs.given.need_jacobian ("gsmbp_trim", m);
  endif
  x = gs.given.given_guess ("gsmbp_trim", m, "x", x, m.initial(d.nq + 1:d.nx));
  if (isempty (v))
    v = zeros (d.nv, 1);
  endif
  named = sprintf (" (the inputs %s)", strjoin (m.inputs', ", "));
  v = gs.given.given_vector ("gsmbp_trim", "v", v, d.nv, named, m.inputs);
endfunction

## held states, free inputs and speeds, what runs, margins, tolerance: as do_trim takes them
function asked = what_is_asked (m, o)
  [d, who] = deal (m.sizes, "gsmbp_trim");
  held = places (who, o.hold, m.states, "hold", "a state");
  gs.given.refuse_mode_names (who, "option free", m, gs.given.asked_names (o.free));
  steady = ! isempty (o.steady);
  pairs = zeros (2, 0);
  if (steady)
    k = places (who, o.free, [m.inputs(:); m.speeds(:)], "free", "an input or a speed");
    for name = cellstr (o.steady)(:)'
      pairs(:,end+1) = gs.given.speed_and_value (who, m, "steady", name{1});
    endfor
  else
    k = places (who, o.free, m.inputs, "free", "an input");
  endif
  asked = {held, k(k <= d.nv), d.nq + k(k > d.nv) - d.nv, steady, pairs, ...
           strcmp(o.margins, "check"), o.tolerance};
endfunction

function k = places (who, names, all_names, option, what)
  names = gs.given.asked_names (names)';
  k = gs.given.places_of (names, all_names);
  if (! all (k))
    error ("%s: option \"%s\": expected the name of %s, found %s", who, option, what,
           gs.text.nearest_word (names{find (! k, 1)}, all_names));
  endif
endfunction

function r = result (m, t, x, v)
  d = m.sizes;
  xd = m.rhs (t, x, v);
  r = struct ("x", x, "v", v, "ud", xd(d.nq + (1:d.nu)), "lambda", zeros (0, 1), ...
              "phi", zeros (0, 1));
  if (d.nlam > 0)
    [~, r.lambda] = m.acc (t, x, v);
    r.phi = m.con (t, x(1:d.nq), zeros (d.nu, 1));
  endif
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! r = gsmbp_trim (m, [0.3; 0; 0], 0, "hold", m.states{1}, "free", m.inputs{1});
%! assert (r.x(1), 0.3);
%! assert (max (abs (m.rhs (0, r.x, r.v))) < 1e-9);
%! assert (isempty (r.indifferent));
%!test <nothing is free, and one input that is free>
%! m = gsmbp_hand ("motor_pendulum");
%! hold = {"hold", m.states([1, 3])};
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, hold{:})", "no equilibrium found near the guess");
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, hold{:}, \"free\", m.inputs{1})", "no equilibrium");
%!error <expected the name of a state, found "nobody"; known: >
%! gsmbp_trim (gsmbp_hand ("motor_pendulum"), [0;0;0], 0, "hold", "nobody")
%!test <what does not vanish, and what could help>
%! m = gsmbp_hand ("motor_pendulum");
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, \"hold\", m.states{1})", ...
%!       "acceleration of .* rad/s\\^2; these");
