## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{sys} =} gsmbp_linear (@var{m}, @var{t}, @var{x}, @var{v})
## @deftypefnx {} {[@var{sys}, @var{T}, @var{free}] =} gsmbp_linear (@dots{}, "reduced", @var{q})
## @deftypefnx {} {[@var{sys}, @var{T}, @var{free}, @var{dropped}] =} gsmbp_linear (@dots{}, @
## "drop", @var{q})
## The exact linear model of a scene as an @code{ss} object of the control
## package, with StateName, InputName and OutputName.
##
## The model @var{m} (of @code{gsmbp_build}) is linearized at the time @var{t}
## [s], the @var{nx} states @var{x} and the @var{nv} inputs @var{v} (zeros by
## default): deviations obey dx' = A dx + B dv, dy = C dx + D dv.  Where the
## scene has no outputs they are its states.  The state must fulfil the constraints:
## one that does not, to 1e-6, is an error, unless "start", "project" is given
## (as in @code{gsmbp_simulate}); below, it is moved onto them.
##
## With loops (or Euler parameters) the states are not independent.  The option
## "reduced" gives the model in independent ones: the coordinates @var{names}
## and their speeds (with constraints of speeds alone, rolling or sleds, there are
## more independent coordinates than speeds: name the speeds too) ("auto", the default where there
## are constraints: chosen by
## the Jacobian) and the actuator states.  Then dx = @var{T} dz for the reduced
## deviations dz, which are the states of the numbers @var{free}.  It is
## exact: on the constraints' tangent space T the full model and the
## reduced one agree, but for rounding: an entry that should be 0 may be 1e-16
## times those beside it, or times the terms of which it is the sum.  @code{eig}
## balances, which can make much of such an entry; @code{gsmbp_modes} works in
## nominal magnitudes instead.  "none" gives the full model (with Baumgarte's terms).
##
## About a steady motion (@code{gsmbp_trim}, "steady") some coordinates run.  "drop" takes the
## coordinates @var{q} out of the model (or "running": those that change at @var{x}), and those that
## only follow them; their names are @var{dropped}.  Nothing else may depend on them, there and
## further on, or it is an error.  What is left has constant coefficients: its poles tell of the
## stability of the motion.  Outputs that follow what is dropped are left out, with a warning.  Of
## constraints on speeds those speeds are taken as independent whose accelerations depend on the
## fewest coordinates, unless "reduced" names them.
##
## Poles tell of stability where the state stands still, or moves steadily in a
## coordinate on which nothing depends (the spin of a wheel in angles, not in Euler
## parameters, which move).
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> x = gsmbp_assemble (m, [-pi/2; 1; 0.4], "hold", "q1");
## >> r = gsmbp_trim (m, x, 0, "hold", "q1", "free", "motor.v");
## >> sys = gsmbp_linear (m, 0, r.x, r.v, "reduced", "q1");
## >> sort (pole (sys))'
## ans =
##
##   -243.9788   -90.7671    -0.2215
## @end example
##
## Errors: a model without the subroutine JAC; a state that does not fulfil
## the constraints; a derivative of a rate that is not finite (of
## an output: a warning); a coordinate to be dropped on which something depends;
## coordinates in "reduced" that are unknown or do not determine the motion.
## Source: own: the Jacobians of _JAC are exact; the reduced model lives on
## the tangent space of the constraints.
## @seealso{gsmbp_build, gsmbp_trim, ss, lqr}
## @end deftypefn

function [sys, T, independent, dropped] = gsmbp_linear (m, t, x, v, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_linear";
  gs.given.check_model (who, m);
  if (! any (strcmp (m.subroutines, "jac")))
    gs.given.need_jacobian (who, m);
  endif
  if (nargin < 4 || isempty (v))
    v = zeros (m.sizes.nv, 1);
  endif
  gs.given.refuse_words (who, "t", t, "x", x, "v", v);
  d = m.sizes;
  table = {"reduced", "auto", "names"
           "drop", {}, "names"
           "start", "check", {"check", "project"}};
  o = gs.given.call_options (who, table, varargin);
  t = gs.given.given_vector (who, "t", t, 1);
  x = gs.start.consistent_start (who, m, t, x, o.start);
  gs.start.warn_of_rank (who, m, t, x, "singular_linear");
  v = gs.given.given_vector (who, "v", v, d.nv, sprintf (" (the inputs %s)", ...
                                                         strjoin (m.inputs', ", ")),
                             m.inputs);
  if (isempty (which ("ss")))
    pkg load control
  endif
  named = ! (ischar (o.reduced) && any (strcmp (o.reduced, {"auto", "none"})));
  wanted = [];
  if (named)
    wanted = state_numbers (m, o.reduced);
  endif
  running = ischar (o.drop) && strcmp (o.drop, "running");
  r = model_of (who, m, t, x, v, merge (named, 0, 1 + strcmp (o.reduced, "none")), wanted, ...
                running, coordinate_numbers (m, o.drop, running));
  outputs = merge (d.ny > 0, m.outputs, m.states);
  dropped = m.states(r.dropped)(:)';
  warn_of_outputs (m, outputs(setdiff (1:numel (outputs), r.seen)), dropped);
  [T, independent] = deal (r.T, r.independent);
  sys = ss (r.A, r.B, r.C, r.D, "statename", m.states(independent), "inputname", m.inputs, ...
            "outputname", outputs(r.seen));
endfunction

## the linear model of host/linear/linear.h
function r = model_of (who, m, t, x, v, varargin)
  at = gs.linear.state_place (m, t, x, v);
  [verdict, text, A, B, C, D, T, independent, dropped, seen, output, by] = ...
      m.module ("linear", at{:}, varargin{:});
  gs.linear.heed_verdict (who, m, verdict, text);
  if (output > 0)
    warning ("gsmbp:derivative", "%s: %s: %s", who, m.name, gs.text.refusal_text ( ...
        "no_derivative", ["output " m.outputs{output}], [m.states(:); m.inputs(:)]{by}));
  endif
  r = struct ("A", A, "B", B, "C", C, "D", D, "T", T, "independent", independent, ...
              "dropped", dropped, "seen", seen);
endfunction

## outputs that follow what is dropped are no part of the model
function warn_of_outputs (m, gone, dropped)
  if (m.sizes.ny > 0 && ! isempty (gone))
    warning ("gsmbp:dropped", "gsmbp_linear: %s: the output%s %s depend%s on %s and %s left out",
             m.name, {"", "s"}{1 + (numel (gone) > 1)}, strjoin (gone(:)', ", "), ...
             {"s", ""}{1 + (numel (gone) > 1)}, strjoin (dropped, ", "), ...
             {"is", "are"}{1 + (numel (gone) > 1)});
  endif
endfunction

## where the NAMES of the option "reduced" stand among the states
function k = state_numbers (m, names)
  names = cellstr (names);
  k = gs.given.places_of (names, m.states);
  if (! all (k) || isempty (k))
    error ("gsmbp_linear: option \"reduced\": %s has no state %s", m.name,
           gs.text.nearest_word ([names(! k)(:); {""}]{1}, m.states));
  endif
endfunction

## ... and those of the option "drop" among the coordinates
function k = coordinate_numbers (m, names, running)
  k = [];
  if (running || isempty (names))
    return;
  endif
  names = cellstr (names)(:)';
  k = gs.given.places_of (names, m.coordinates);
  if (! all (k))
    error (["gsmbp_linear: option \"drop\": expected the name of a coordinate or \"running\", " ...
            "found %s"], gs.text.nearest_word (names{find (! k, 1)}, m.coordinates));
  endif
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! sys = gsmbp_linear (m, 0, [0 0 0], 0);
%! assert (get (sys, "stname"), m.states);
