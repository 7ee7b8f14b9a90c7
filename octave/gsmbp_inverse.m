## -*- texinfo -*-
## @c category Runs
## @deftypefn  {} {@var{r} =} gsmbp_inverse (@var{m}, @var{motion}, @var{times})
## @deftypefnx {} {@var{r} =} gsmbp_inverse (@var{m}, @var{motion}, @var{times}, @
## @var{options}, @dots{})
## Inverse dynamics along a planned motion, through loops and actuators.
##
## @var{motion} (of @code{gsmbp_plan}) plans the actuated coordinates of the
## model @var{m}, or all coordinates of an open chain.  The result holds a row
## for each of the @var{times} [s]:
## @table @code
## @item t, q, u, ud
## time, coordinates, speeds, accelerations (those of a loop completed)
## @item qj
## nu x (1 + command order) x times: the motion with all its derivatives
## @item tau
## efforts of the actuated coordinates (of all, in an open chain) that the
## inverse model needs, and @code{lambda}, the multipliers of the loops; @code{unique}
## tells which of these the motion determines (the others are one of many values)
## @item v
## inputs, from the inverse models of the devices (where emitted)
## @item x
## the states along the motion, those of devices included: from the inverse
## models, internal ones integrated by their own rates from the option "internal"; without an
## inverse model, from the condition that the right-hand side yields the
## planned accelerations (NaN where no states of the devices do)
## @item y, points, of
## outputs of the scene, places of its points, every column by its name (@code{gsmbp_names})
## @item margins
## times x number of margins, above 0 where the command can be given
## @item violations
## a struct array, empty if all is well: @code{text} of the margin, or the input that passes its
## limits, @code{time} of its first violation, @code{least} value, and @code{said}, a sentence
## @end table
## Options: "side": which limit to take at a break of the motion, 1 from the
## right (default), -1 from the left; "input": @var{nv} inputs from outside,
## which tau counts (default zeros; v, margins and the states of devices are NaN then, no violations
## are told; a warning says so); "guess": the @var{nu} coordinates where
## Newton's method for the loops begins (default @code{m.initial}); "quasistatic": true takes the
## drives as quasi-static, rates within them neglected (the variants without such states: a motor
## without inductance), v and margins are those, their states are NaN; "internal":
## states of the devices at the first time (default @code{m.initial}); "limits" of the inputs (what
## a supply gives): one number (both ways), @var{nv} numbers, or @var{nv} x 2 (least, largest);
## default their @code{limits} in the scene.
##
## Of a scene with flexible links that was emitted with the request @code{static_modes}
## the motion may be that of the coordinates alone that INQ is given
## (@code{m.json.given}): the modal coordinates, and what follows through loops, are then
## in quasi-static balance, their rates zero; @code{tau} has a column for each coordinate,
## zero but for those given; no inputs @code{v}, outputs and states of devices follow.
##
## A motion with fewer continuous derivatives than the command needs
## (@code{m.order - 1}: the voltage of a motor with inductance, of order 3, needs a continuous
## acceleration) is an error that names the device and the time; "quasistatic" takes it.
## The motion is of all coordinates of an open chain, of the actuated ones of a
## closed one.  If a loop cannot follow it, it is an error that names the time.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> plan = gsmbp_plan ("quintic", [0 pi], [0 1]);
## >> r = gsmbp_inverse (m, plan, [0; 0.25; 1]);
## >> [r.t, r.q, r.v]
## ans =
##
##          0         0         0    0.7000    1.0564
##     0.2500    0.3252   -0.4534    0.6854   17.4771
##     1.0000    3.1416   -3.1416    0.3000   -1.0088
## @end example
##
## Errors: a motion whose derivatives jump; a motion of other components than the actuated
## coordinates; a loop that cannot follow it (the time is said); a missing subroutine; an option
## that is unknown or of another size.
## Source: Ju and Hsu (1991), inverse dynamics with multipliers.
## @seealso{gsmbp_plan, gsmbp_simulate}
## @end deftypefn

function r = gsmbp_inverse (m, motion, times, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_inverse";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "motion", motion, "times", times);
  d = m.sizes;
  if (isempty (times))
    error ("%s: argument times: expected one time or more, found none", who);
  endif
  table = {"side", 1, "number"
           "input", zeros(d.nv, 1), "numbers"
           "guess", m.initial(1:d.nq), "numbers"
           "quasistatic", false, "flag"
           "internal", m.initial(d.nq+d.nu+1:end), "numbers"
           "limits", [], "any"};
  o = gs.given.call_options (who, table, varargin);
  if (any (strcmp (m.subroutines, "inq")) && states_given (who, m, motion))
    times = gs.given.given_vector (who, "times", times, numel (times))';
    r = gs.plan.inverse_modes (who, m, motion, times, checked (who, m, o));
    return;
  endif
  [pp, planned] = gs.given.given_motion (who, m, motion);
  o = checked (who, m, o);
  times = gs.given.given_vector (who, "times", times, numel (times))';
  static = o.quasistatic && quasi_static (who, m);
  has = @(name) any (strcmp (m.subroutines, name)) ...
                && ! (static && any (strcmp (name, {"cmd", "cmx"})));
  gs.plan.check_continuous (who, m, pp, planned, times, o.quasistatic);
  nt = numel (times);
  loops = d.nlam > 0;
  r.t = times(:);
  r.tau = zeros (nt, merge (loops, d.nact, d.nu));
  r.lambda = zeros (nt, d.nlam);
  r.unique = m.unique.multipliers;
  r.v = zeros (nt, d.nv);
  r.x = zeros (nt, d.nx);
  r.margins = zeros (nt, numel (m.margins));
  if (static)
    r.margins = zeros (nt, numel (m.static_margins));
  endif
  given = {who, m, pp, planned, times, o.side, o.guess};
  if (has ("cmx"))
    given{end+1} = o.internal;
  endif
  [qj, xi] = gs.plan.along_plan (given{:});
  for i = 1:nt
    one = qj(:,:,i);
    if (loops)
      [r.tau(i,:), r.lambda(i,:)] = m.inl (times(i), one(:,1), one(:,2), one(:,3), o.input);
    elseif (has ("inv"))
      r.tau(i,:) = m.inv (times(i), one(:,1), one(:,2), one(:,3), o.input);
    endif
    if (has ("cmx"))
      [r.v(i,:), xid, xa, r.margins(i,:)] = m.cmx (times(i), one, xi(:,i));
      r.x(i,:) = [one(:,1); one(:,2); xa];
    elseif (static)
      [r.v(i,:), r.margins(i,:)] = static_command (m, times(i), one(:,1:3));
      r.x(i,:) = [one(:,1); one(:,2); NaN(d.nx - 2 * d.nu, 1)];
    else
      if (has ("cmd"))
        r.v(i,:) = m.cmd (times(i), one);
      endif
      if (has ("rhs"))
        r.x(i,:) = states (m, times(i), one, r.v(i,:)', r.x(max (i - 1, 1),:)');
      endif
    endif
  endfor
  known = static || has ("cmd");
  if (known && any (o.input != 0))
    known = false;
    r.x(:,d.nq+d.nu+1:end) = r.v(:) = r.margins(:) = NaN;
    warning ("gsmbp:inverse", ...
             ["%s: v, margins and the states of devices in x are not determined (NaN): the " ...
              "command takes no inputs from outside (option \"input\"); tau counts them"], who);
  endif
  if (known)
    texts = {m.margins, m.static_margins}{1 + static};
    r.violations = gs.plan.limit_violations (m, r, texts, o.limits);
  else
    r.violations = unknown_violations (who, m, o);
  endif
  r.q = reshape (qj(:,1,:), d.nu, nt)';
  r.u = reshape (qj(:,2,:), d.nu, nt)';
  r.ud = reshape (qj(:,3,:), d.nu, nt)';
  r.qj = qj;
  r.y = NaN (nt, d.ny);
  if (! static && ! has ("cmd"))
    r.v = zeros (nt, 0);
    told_without (who, m, r);
  elseif (! isempty (r.x))
    r.y = gs.run.output_values (m, r.t, r.x, r.v);
  endif
  r = gs.model.named_results (m, r);
endfunction

## a motion of the coordinates that the scene takes as given?
function yes = states_given (who, m, motion)
  pp = gs.given.given_polynomial (who, motion);
  yes = prod (pp.dim) == numel (m.json.given);
endfunction

## none, where the inputs are not determined: limits that were asked for are an error
function list = unknown_violations (who, m, o)
  reason = "the command takes no inputs from outside (option input)";
  if (! any (o.input != 0))
    reason = ["no inputs v: " gs.text.why_left_out(m, "command")];
  endif
  if (o.limited)
    error ("%s: option limits: the inputs are not determined: %s", who, reason);
  elseif (any (isfinite (o.limits(:))))
    warning ("gsmbp:inverse", ["%s: not compared with the limits of the inputs in the scene: " ...
                               "%s"], who, reason);
  endif
  list = gs.plan.limit_violations (m, struct ("v", []), {}, []);
endfunction

## states of devices that a result without inputs does not tell, and why
function told_without (who, m, r)
  lost = m.states(any (isnan (r.x), 1))(:)';
  if (isempty (lost))
    return;
  endif
  try
    m.cmd (r.t(1), r.qj(:,:,1));
  catch problem
    warning ("gsmbp:inverse", ...
             "%s: not determined by the motion (NaN in x): %s; no inputs v: %s", ...
             who, strjoin (lost, ", "), problem.message);
  end_try_catch
endfunction

## whether the command of the drives as quasi-static is there
function yes = quasi_static (who, m)
  yes = any (strcmp (m.subroutines, "cmq"));
  if (! yes && m.order > 2)
    error (["%s: option quasistatic: %s has no subroutine CMQ: %s"], who, m.name, ...
           gs.text.why_left_out (m, "quasi_static"));
  endif
endfunction

function [v, margins] = static_command (m, t, qj)
  margins = zeros (1, 0);
  if (isempty (m.static_margins))
    v = m.cmq (t, qj);
  else
    [v, margins] = m.cmq (t, qj);
  endif
endfunction

function o = checked (who, m, o)
  d = m.sizes;
  if (d.nq != d.nu)
    error (["%s: %s has Euler parameters: a planned motion cannot state its %d " ...
            "coordinates by %d speeds; derive it with angles of orientation"], who, m.name, ...
           d.nq, d.nu);
  endif
  o.guess = gs.given.given_vector (who, "option guess", o.guess, d.nq, "", m.coordinates);
  o.internal = gs.given.given_vector (who, "option internal", o.internal, d.nx - d.nq - d.nu, "",
                                      m.states(d.nq+d.nu+1:end));
  o.input = gs.given.given_vector (who, "option input", o.input, d.nv, "", m.inputs);
  o.limited = ! isempty (o.limits);
  o.limits = gs.given.given_bounds (who, "option limits", o.limits, d.nv);
  if (! o.limited)
    o.limits = gs.model.scene_limits (m, m.inputs);
  endif
  if (! (isscalar (o.side) && any (o.side == [-1, 1])))
    error ("%s: option side: expected 1 or -1, found %s", who, gs.text.shown_value (o.side));
  endif
endfunction

## the states of the actuators behind q and u: Newton on u' of the right-hand
## side against the planned one (linear actuators: one step); NaN where it does not determine them
function x = states (m, t, qj, v, last)
  d = m.sizes;
  speeds = d.nq + (1:d.nu);
  rest = d.nq + d.nu + 1:d.nx;
  known = last(rest);
  known(isnan (known)) = 0;
  x = [qj(:,1); qj(:,2); known];
  if (isempty (rest))
    return;
  endif
  for iteration = 1:20
    xd = m.rhs (t, x, v);
    miss = qj(:,3) - xd(speeds);
    J = zeros (d.nu, numel (rest));
    for k = 1:numel (rest)
      y = x;
      h = 1e-3 * max (1, abs (x(rest(k))));
      y(rest(k)) += h;
      J(:,k) = (m.rhs (t, y, v)(speeds) - xd(speeds)) / h;
    endfor
    step = pinv (J) * miss;
    x(rest) += step;
    if (norm (step, Inf) <= 1e-11 * max (1, norm (x(rest), Inf)))
      break;
    endif
  endfor
  if (! (norm (qj(:,3) - m.rhs (t, x, v)(speeds), Inf) <= 1e-6 * max (1, norm (qj(:,3), Inf))))
    x(rest) = NaN;   # no states of these devices give such accelerations
    return;
  endif
  size_of = max (abs (J), [], 1);
  size_of(size_of == 0) = 1;
  free = null (J ./ size_of, 1e-9);
  x(rest(any (abs (free) > 1e-6, 2))) = NaN;
endfunction

%!shared m, c
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! c = gsmbp_hand ("hand_crank");
%!test <open chain with a motor>
%! plan = gsmbp_plan ("quintic", [0.3 1], [0 1]);
%! r = gsmbp_inverse (m, plan, [0 0.5 1]);
%! assert (r.tau(1), 1.2 * 9.81 * 0.5 * sin (0.3), 1e-13);
%! assert (r.x(1,3), r.tau(1) / 2, 1e-9);
%! assert (size (r.qj), [1 4 3]);
%!test <closed chain: power in equals the rate of energy>
%! plan = gsmbp_plan ("septic", [0.3 2], [0 1]);
%! r = gsmbp_inverse (c, plan, 0.5);
%! e = @(t) [1 1 0 0 0] * c.ene (0, gsmbp_inverse (c, plan, t).x');
%! assert (r.tau * r.u(1), (e (0.5 + 1e-4) - e (0.5 - 1e-4)) / 2e-4, 1e-6);
%! assert (c.con (0, r.q'), [0; 0], 1e-15);
%!error <cannot follow the motion at t = >
%! gsmbp_inverse (gsmbp_set (c, "l2", 0.1), gsmbp_plan ("quintic", [0 3], [0 1]), 0:0.1:1)
%!error <expected 1 components \(q1\), found 2>
%! gsmbp_inverse (c, gsmbp_plan ("quintic", [0 3; 0 1], [0 1]), 0)
