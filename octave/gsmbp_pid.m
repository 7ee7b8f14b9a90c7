## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{c} =} gsmbp_pid (@var{m}, @var{e}, @var{kind}, @var{goal}, @var{value}, @
## @dots{})
## @deftypefnx {} {@var{c} =} gsmbp_pid (@var{sys}, [], @var{kind}, @dots{})
## A P, PI, PD or PID controller tuned to a phase margin, a gain margin or the largest sensitivity
## Ms.
##
## The model @var{m} is linearized about the trim @var{e} (@code{gsmbp_trim}), or @var{sys} is a
## model with one input and one output (@code{ss}, @code{tf}).  @var{kind} is "p", "pi", "pd" or
## "pid": u = Kp*(bp*r - y) + Ki*integral(r - y) + Kd*rate(bd*r - y), the rate with the lag Tf =
## Td/N; Ti = Kp/Ki, Td = Kd/Kp.
##
## Goals (one, or "pm" and "gm" together for "pi"; dead time and sampling are taken exactly):
## @table @code
## @item "pm"
## phase margin [degrees]
## @item "gm"
## gain margin
## @item "ms"
## the largest |1/(1 + L)| of all frequencies
## @end table
##
## Options:
## @table @code
## @item "Ti", "Td"
## [s]; without Ti the one of the largest Ki that keeps the goal, without Td Ti/4 (pid) or that of
## the largest Kp (pd)
## @item "N"
## 10: the lag of the rate
## @item "bp", "bd"
## weights of the reference, 1 and 0
## @item "delay"
## [s]: dead time of the loop; with a period that of the computer
## @item "period"
## 0: continuous; else [s], sums for integrals, differences for rates, as @code{digital_pid}
## @item "measured", "inputs", "limits", "step_in", "step_out", "name", "reduced", "drop"
## as of @code{gsmbp_control}; one name each
## @end table
##
## @var{c} is a controller as of @code{gsmbp_control}, with @code{Kp}, @code{Ki}, @code{Kd},
## @code{Ti},
## @code{Td}, @code{Tf} and @code{margins}: @code{phase} [rad] at @code{crossover} [rad/s],
## @code{gain} at @code{phase_crossover}, @code{Ms} at @code{Ms_at}, @code{delay} [s].
##
## @c session control
## @example
## >> c = gsmbp_pid (tf (2, [1.5 1]), [], "pi", "pm", 60, "Ti", 1.5, "delay", 0.4);
## >> c.Kp, c.margins.gain
## ans = 0.9817
## ans = 3.0000
## @end example
##
## Errors: no goal; a goal that no gain reaches with a stable loop; more than one input or output.
## Source: frequency response, exact with dead time; roots by bisection; largest Ki under Ms as in
## Astrom and Hagglund, Advanced PID Control; stability by Nyquist's criterion.
## @seealso{gsmbp_control, gsmbp_build, gsmbp_controller, gsmbp_loop}
## @end deftypefn

function c = gsmbp_pid (m, e, kind, varargin)
  if (nargin < 5)
    print_usage ();
  endif
  who = "gsmbp_pid";
  gs.given.refuse_words (who, "e", e);
  if (isempty (which ("lqr")))
    pkg load control
  endif
  gs.given.check_kind (who, "argument kind", kind, {"p", "pi", "pd", "pid"});
  table = {"pm", [], "positive"; "gm", [], "positive"; "ms", [], "positive"
           "Ti", [], "positive"; "Td", [], "positive"; "N", 10, "positive"
           "bp", 1, "number"; "bd", 0, "number"
           "delay", 0, "nonnegative"; "period", 0, "nonnegative"
           "measured", {}, "names"; "inputs", {}, "names"
           "limits", Inf, "any"; "step_in", 0, "nonnegative"; "step_out", 0, "nonnegative"
           "name", "pid", "text"; "reduced", "auto", "names"; "drop", {}, "names"};
  o = gs.given.call_options (who, table, varargin);
  goal = what_is_asked (who, kind, o);
  [o.integral, o.track] = deal ({});
  p = gs.control.linear_plant (who, m, e, o);
  if (numel (p.measured) != 1 || numel (p.driven) != 1)
    error (["%s: expected one measurement and one input, found %s and %s (options measured, " ...
            "inputs)"], who, strjoin (p.measured', ", "), strjoin (p.driven', ", "));
  endif
  p.references = strcat (p.measured, "_ref");
  p.r0 = p.y0;
  if (o.period > 0)
    p = gs.control.sampled_plant (who, p, o);
  else
    [p.h, p.plant] = deal (0, ss (p.A, p.B, p.C, 0, "statename", p.states, "inputname", ...
                                  p.driven, "outputname", p.measured));
  endif
  [K, Ti, Td] = gs.control.pid_tuned (who, p, o, kind, goal);
  c = controller (p, o, kind, K, Ti, Td);
  c.limits = gs.given.two_limits (who, o.limits, c.driven, c.u0);
  c.margins = gs.control.loop_margins (gs.control.loop_response (c, 1), ...
                                       gs.control.frequency_grid (p, o.delay, [Ti, Td]));
  c.poles = [];
  if (o.period > 0 || o.delay == 0)
    c.poles = gs.control.closed_poles (c);
  endif
endfunction

## [name, value; ...] of the goals
function goal = what_is_asked (who, kind, o)
  names = {"pm", "gm", "ms"};
  values = {o.pm, o.gm, o.ms};
  given = ! cellfun (@isempty, values);
  both = isequal (given, [true, true, false]) && strcmp (kind, "pi") && isempty (o.Ti);
  if (sum (given) != 1 && ! both)
    error (["%s: expected one goal, pm, gm or ms (for \"pi\" without Ti also pm and gm), found " ...
            "%d"], who, sum (given));
  endif
  if ((given(1) && o.pm >= 180) || (given(2) && o.gm <= 1) || (given(3) && o.ms <= 1))
    error (["%s: expected a phase margin below 180 degrees, a gain margin above 1, Ms above 1; " ...
            "found %g"], who, values{find (given, 1)});
  endif
  if ((any (strcmp (kind, {"p", "pd"})) && ! isempty (o.Ti)) || ...
      (any (strcmp (kind, {"p", "pi"})) && ! isempty (o.Td)))
    error ("%s: a \"%s\" has no %s", who, kind, {"Td", "Ti"}{1 + ! isempty(o.Ti)});
  endif
  goal = [names(given); values(given)];
endfunction

## the law as a controller
function c = controller (p, o, kind, K, Ti, Td)
  h = p.h;
  Ki = K / Ti;
  Kd = K * Td;
  Tf = Td / o.N;
  weights = [-1, o.bp];
  rate = [-1, o.bd];
  c = struct ("A", zeros (0), "B", zeros (0, 2), "C", zeros (1, 0), "D", K * weights, ...
              "G", zeros (0, 1));
  if (isfinite (Ti))
    c.A = double (h > 0);
    c.B = Ki * merge (h > 0, h, 1) * [-1, 1];
    c.C = 1;
    c.G = merge (h > 0, min (1, h / Ti), 1 / Ti);
  endif
  if (Td > 0)
    a = merge (h > 0, Tf / (Tf + h), -1 / Tf);
    b = Kd / (Tf + h);
    c.A = blkdiag (c.A, a);
    c.B = [c.B; b * merge(h > 0, a - 1, -1 / Tf) * rate];
    c.C = [c.C, 1];
    c.D += b * rate;
    c.G = [c.G; 0];
  endif
  [c.Kp, c.Ki, c.Kd, c.Ti, c.Td, c.Tf] = deal (K, Ki, Kd, Ti, Td, Tf);
  c.name = o.name;
  c.method = kind;
  [c.period, c.delay] = deal (o.period, o.delay);
  for field = {"measured", "driven", "references", "y0", "r0", "u0", "x0", "plant"}
    c.(field{1}) = p.(field{1});
  endfor
  [c.step_in, c.step_out] = deal (o.step_in, o.step_out);
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! pkg load control
%! c = gsmbp_pid (tf (2, [1.5 1]), [], "pi", "pm", 60, "Ti", 1.5, "delay", 0.4);
%! assert (c.Kp, pi / 6 * 1.5 / 0.8, 1e-13);
%! assert (c.margins.gain, 3, 1e-12);
%!error <expected one goal> gsmbp_pid (1, [], "pi", "Ti", 3)
