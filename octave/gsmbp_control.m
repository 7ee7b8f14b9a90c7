## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{c} =} gsmbp_control (@var{m}, @var{e}, @var{method}, @var{option}, @
## @var{value}, @dots{})
## @deftypefnx {} {@var{c} =} gsmbp_control (@var{sys}, [], @var{method}, @dots{})
## A controller for a scene about an equilibrium or a steady motion.
##
## The model @var{m} is linearized by its exact Jacobians about @var{e}, the result of
## @code{gsmbp_trim} (or any struct with @code{x} and @code{v}); or @var{sys} is a model
## (@code{ss}) with names of its own, about zero.  @var{method}:
## @table @code
## @item "lqr"
## the state feedback that is best by the weights "Q" and "R"
## @item "lqg"
## the same from states that a Kalman filter estimates by the covariances "W" and "V"
## @item "place"
## the state feedback with the closed poles "poles"
## @item "output"
## static feedback of what is measured, best by "Q" and "R" for deviations of unit covariance at the
## start (Levine and Athans); from "start", a gain that stabilizes, or one that is found
## @item "hinf"
## mixed sensitivity: the controller that is least in the H-infinity norm of [W1 S; W2 K S; W3 T]
## @end table
##
## Options:
## @table @code
## @item "measured", "inputs"
## names of the outputs that the controller reads (default all), of the inputs that it drives
## (default all that no other device holds)
## @item "Q", "R", "W", "V"
## weights of the states and inputs (Qi: of integrals), covariances of the disturbances of states
## and of measurements: matrices, diagonals or numbers, default 1.  With a period the cost is the
## sum over the samples, W the intensity of continuous noise, V the covariance of a sample
## @item "poles", "observer_poles"
## [1/s]; with a period they are exp(p h) in the plane of z.  Those of the observer default to three
## times as far left
## @item "observer"
## "none": all states follow from what is measured; "full", of all states; "reduced": of those that
## are not measured; "kalman" (that of "lqg").  Default: "none" where it can be, else "full"
## @item "integral"
## names of measured outputs that are to reach their references: their errors are integrated
## @item "track"
## names of measured outputs that follow references without integrals, by a constant gain
## @item "period", "delay"
## [s]: the controller acts at k times the period, its output comes the delay later (both are part
## of the design).  0 (default): continuous
## @item "limits", "step_in", "step_out"
## the inputs stop there (one number, one for each, or lower and upper in two columns); steps of the
## converters of measurements and outputs (0: none)
## @item "weights"
## hinf: @{W1, W2, W3@}, each a number, a transfer function or []
## @item "name", "reduced", "drop"
## name of the controller (default "ctl"); as in @code{gsmbp_linear}.  Where discs roll, coordinates
## remain that no input reaches: "drop" takes them out
## @end table
##
## @var{c} holds what runs: with deviations e = [y - y0; r - r0] of measurements and references
## raw = u0 + C z + D e, out = raw within the limits, rounded, next z = A z + B e + G (out - raw)
## (continuous: z').  Integrals and observers at zero are at the trim: it starts without a bump.  G
## keeps observers true and integrals from winding up where out is limited.  Its fields:
## @table @code
## @item A, B, C, D, G, period, delay
## this controller
## @item measured, references, driven
## names of what it reads and drives; y0, r0, u0: their values at the trim
## @item limits, step_in, step_out
## as given, for each
## @item K, L
## gains of the states (delayed inputs and integrals behind them) and of the observer; F: of
## measurements (output); gamma: the norm that was reached (hinf)
## @item states
## names of the columns of K
## @item poles
## closed poles of linear model and controller together (of z with a period)
## @item plant
## the model, an ss object (with a period: sampled, the delay among its states)
## @end table
## @code{gsmbp_build (name, "controller", c)} builds the machine with it, @code{gsmbp_controller}
## writes it as Fortran and C of its own, @code{gsmbp_loop} tells margins and draws the page.
##
## @c session control
## @example
## >> pkg load control
## >> A = [0 1; 0 0]; B = [0; 1];
## >> c = gsmbp_control (ss (A, B, eye (2), 0), [], "lqr", "Q", [1 0], "R", 1);
## >> c.K
## ans =
##
##    1.0000   1.4142
## @end example
##
## Errors: an unknown method, option or name; sizes that do not fit; states that cannot be
## controlled or seen; poles that cannot be placed; a closed loop that is not stable; a derivative
## that is not finite.
## Source: Riccati's equations and H-infinity by the control package, on balanced states, refined by
## Newton's method (Kleinman); Luenberger; Levine and Athans.
## @seealso{gsmbp_trim, gsmbp_linear, gsmbp_build, gsmbp_controller, gsmbp_loop, gsmbp_pid}
## @end deftypefn

function c = gsmbp_control (m, e, method, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_control";
  gs.given.refuse_words (who, "e", e);
  if (isempty (which ("lqr")))
    pkg load control
  endif
  methods_ = {"lqr", "lqg", "place", "output", "hinf"};
  gs.given.check_kind (who, "argument method", method, methods_);
  table = {"measured", {}, "names"; "inputs", {}, "names"
           "Q", 1, "numbers"; "Qi", 1, "numbers"; "R", 1, "numbers"
           "W", 1, "numbers"; "V", 1, "numbers"
           "poles", [], "any"; "observer_poles", [], "any"
           "observer", "", {"", "none", "full", "reduced", "kalman"}
           "integral", {}, "names"; "track", {}, "names"
           "period", 0, "nonnegative"; "delay", 0, "nonnegative"
           "limits", Inf, "any"; "step_in", 0, "numbers"; "step_out", 0, "numbers"
           "weights", {}, "any"; "start", [], "numbers"
           "name", "ctl", "text"; "reduced", "auto", "names"; "drop", {}, "names"};
  o = gs.given.call_options (who, table, varargin);
  p = gs.control.linear_plant (who, m, e, o);
  p = gs.control.sampled_plant (who, p, o);
  try
    c = finished (who, p, o, designed (who, p, o, method), method);
  catch err
    error (struct ("message", [err.message, p.rolling], "identifier", err.identifier));
  end_try_catch
endfunction

function c = designed (who, p, o, method)
  switch (method)
    case "output"
      c = gs.control.output_feedback (who, p, o);
    case "hinf"
      c = gs.control.hinf_law (who, p, o);
    otherwise
      c = gs.control.state_feedback (who, p, o, method);
  endswitch
endfunction

## what all controllers have, and whether they hold the plant
function c = finished (who, p, o, c, method)
  c.name = o.name;
  c.method = method;
  [c.period, c.delay] = deal (o.period, o.delay);
  for field = {"measured", "driven", "references", "y0", "r0", "u0", "x0", "plant"}
    c.(field{1}) = p.(field{1});
  endfor
  nu = numel (c.driven);
  c.limits = gs.given.two_limits (who, o.limits, c.driven, c.u0);
  c.step_in = spread (who, "step_in", o.step_in, numel (c.measured));
  c.step_out = spread (who, "step_out", o.step_out, nu);
  [c.poles, worst] = gs.control.closed_poles (c);
  if (! (worst < 0))
    error ("gsmbp:unstable", ["%s: the closed loop is not stable: poles %s"], who, ...
           gs.text.pole_text (c.poles, c.period));
  endif
endfunction

function v = spread (who, what, v, n)
  if (isscalar (v))
    v = repmat (v, n, 1);
  endif
  v = double (v(:));
  if (numel (v) != n || any (v < 0) || ! all (isfinite (v)))
    error ("%s: option %s: expected 1 or %d numbers that are not negative, found %s", who, what, ...
           n, gs.text.shown_value (v));
  endif
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! pkg load control
%! sys = ss ([0 1; 0 0], [0; 1], eye (2), 0);
%! c = gsmbp_control (sys, [], "lqr", "Q", [1 0]);
%! assert (c.K, [1, sqrt(2)], 1e-14);
%! assert (c.D, -c.K, 1e-14);
%! c = gsmbp_control (sys(1,:), [], "place", "poles", [-1 -2], "observer_poles", [-5 -6]);
%! assert (sort (c.poles), [-6; -5; -2; -1], 1e-12);
%! c = gsmbp_control (sys(1,:), [], "place", "poles", [-1 -2], "observer", "reduced");
%! assert (sort (real (c.poles)), [-3; -2; -1], 1e-12);
%!error <method: expected one of> gsmbp_control (1, [], "lqq")
