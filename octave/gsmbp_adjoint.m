## -*- texinfo -*-
## @c category Runs
## @deftypefn  {} {@var{a} =} gsmbp_adjoint (@var{m}, @var{x0}, @var{times}, @var{goal})
## @deftypefnx {} {@var{a} =} gsmbp_adjoint (@dots{}, "input", @var{v}, "rtol", @var{rtol})
## Derivatives of goals of a run by all parameters and start values at once, by a run forward and
## one way back through its steps.
##
## The cost does not grow with the number of parameters, but with that of the goals: with many
## parameters and few goals this is the way, else option "sensitivity" of @code{gsmbp_simulate}.
## The model @var{m} has the request @code{adjoint} (with @code{sensitivity(m1, k)}: these
## parameters, else all).  @var{goal} is a function @code{[J, Jx, Jy] = goal (r)} of the run
## @var{r}, a struct with @code{t}, @code{x}, @code{v}, @code{y} (rows for @var{times}, as of
## @code{gsmbp_simulate}):
## @var{J}, the goals, a column; @var{Jx}, @var{Jy} their derivatives by @code{r.x} and @code{r.y},
## of their size, with a page for each goal; @var{Jy} may be left out or [].
##
## Options: "input" (constants or a piecewise polynomial), "rtol" (1e-10), "atol", "start", "dx0"
## and "fixed" as in @code{gsmbp_simulate} (@code{dx0}: @var{nx} rows, a column for each parameter).
## The steps are those of dp853 with loops left to Baumgarte's terms.  Ctrl-C, or "timeout" [s],
## ends the ways forward and back; half of them is no result, and that is an error.
##
## @var{a} has the fields @code{J}; @code{dJ}, a struct by the names of the parameters, a column
## for the goals; @code{dx0}, their derivatives by the start values of the states, a row for each
## goal (with loops those that keep them closed alone mean something); @code{run}, the run;
## @code{steps}; @code{seconds}, forward and back.
## They are the derivatives of the J that was computed (a discrete adjoint), whatever the tolerance.
##
## @c session octave
## @example
## >> file = fopen ("swing.mac", "w");
## >> fputs (file, "scene : gsmbp_scene(\"swing\", gravity = [0, -g, 0], ");
## >> fputs (file, "link(rod, mass = m, centre = [l, 0, 0], inertia = [0, 0, 0.01]), ");
## >> fputs (file, "revolute(A, ground, rod, axis = z, coordinate = q), ");
## >> fputs (file, "input(tau, unit = N*m), drive(motor, joint = A, effort = tau), ");
## >> fputs (file, "parameters = [g = 9.81, m = 2*kg, l = 0.5*m])$ ");
## >> fputs (file, "requests : '[all, adjoint, sensitivity(m, l)]$");
## >> fclose (file);
## >> gsmbp_derive ("swing.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("swing");
## >> goal = @@(r) deal (r.x(end,1), [zeros(rows (r.x) - 1, 2); 1 0]);
## >> a = gsmbp_adjoint (m, [0; 0], [0 0.2 0.4], goal, "input", 9);
## >> [a.J, a.dJ.m, a.dJ.l]
## ans =
##
##   -0.1262  -0.6980  -2.5476
## @end example
##
## Errors: a model without ADJ; a scene with events or sampled devices; a goal whose derivatives
## have not the size of the run; a build in quad precision; steps that become too small; Ctrl-C.
## Source: own: reverse differentiation of straight-line code and of Runge-Kutta steps (Hager 2000).
## @seealso{gsmbp_simulate, gsmbp_sensitivity}
## @end deftypefn

function a = gsmbp_adjoint (m, x0, times, goal, varargin)
  if (nargin < 4)
    print_usage ();
  endif
  who = "gsmbp_adjoint";
  gs.given.check_model (who, m);
  gs.given.refuse_words (who, "x0", x0, "times", times);
  o = options (who, m, varargin);
  d = m.sizes;
  p = gs.run.plan_run (who, m, x0, times, o);
  first = gs.run.prepare_run (who, p);
  S0 = reshape (first.x(d.nx+1:end), d.nx, []);
  run = setfield (p.given, "columns", []);   # the way forward has none
  times = p.times;
  o.input = gs.run.whole_input (who, m, o.input, times(1), first.x(1:d.nx));
  breaks = gs.run.switch_times (m);
  if (isstruct (o.input))
    breaks = [breaks, o.input.breaks(2:end-1)];
  endif
  stops = unique ([times(:)', breaks(breaks > times(1) & breaks < times(end))]);
  [~, at] = ismember (times(:)', stops);
  clock_ = tic ();
  left = @() setfield (run, "timeout", ...   # 0: no end
                       max (0, o.timeout - toc (clock_)) + (o.timeout > 0) * 1e-9);
  [record, counts, x, info, reached] = m.module ("forward", m.cst, left (), stops');
  a.seconds = toc (clock_);
  cut_short (who, m, info, "forward", reached);
  if (info != 0)
    error ("%s: %s: the step became too small at t = %.9g s", who, m.name, reached);
  endif
  a.steps = columns (record);
  r = run_of (m, o, times, x(:,at)');
  [a.J, gx, gy] = weights (who, m, r, goal);
  names = cellstr (m.json.sensitivity)(:);
  dJ = zeros (numel (a.J), numel (names));
  a.dx0 = zeros (numel (a.J), d.nx);
  for g = 1:numel (a.J)
    [wx, wp] = at_outputs (m, r, gx(:,:,g), gy(:,:,g), numel (names));
    W = zeros (d.nx, numel (stops));
    W(:,at) = wx;
    begin = tic ();
    [lx, pb, info, t] = m.module ("backward", m.cst, left (), record, counts, W);
    a.seconds(1+g) = toc (begin);
    cut_short (who, m, info, "back", t);
    if (info != 0)
      error ("%s: %s: ADJ failed with INFO = %d at t = %.9g s: %s", who, m.name, info, t, ...
             m.module ("meaning", "adj", info));
    endif
    a.dx0(g,:) = lx';
    dJ(g,:) = (pb + wp)' + lx' * S0;
  endfor
  a.dJ = cell2struct (num2cell (dJ, 1)(:), names, 1);
  a.run = r;
endfunction

## the options, those of a run completed
function o = options (who, m, given)
  if (! any (strcmp (m.subroutines, "adj")))
    error (["%s: %s was emitted without the subroutine ADJ: derive it with the request " ...
            "adjoint of gsmbp_fortran"], who, m.name);
  elseif (strcmp (m.precision, "quad"))
    error ("%s: expected a build in double precision; %s was built in quad", who, m.name);
  endif
  if (! isempty (m.controllers))
    error ("%s: no adjoint through samples; %s has sampled devices (%s)", who, m.name, ...
           m.controllers(1).name);
  endif
  table = {"input", [], "any"
           "rtol", 1e-10, "tolerance"
           "atol", [], "any"
           "fixed", {}, "names"
           "dx0", [], "numbers"
           "timeout", 0, "nonnegative"
           "start", "check", {"check", "project"}};
  given = gs.given.call_options (who, table, given);
  if (is_function_handle (given.input) || ischar (given.input))
    error ("%s: option input: expected constants or a piecewise polynomial, found %s", who, ...
           gs.text.shown_value (given.input));
  endif
  all_ = gs.run.option_table ();
  o = cell2struct (all_(:,2), all_(:,1), 1);
  for name = table(:,1)'
    o.(name{1}) = given.(name{1});
  endfor
  o.sensitivity = m.json.sensitivity;
  o.projection = false;   # steps are those of equations with multipliers alone
endfunction

function cut_short (who, m, info, way, at)
  word = gs.run.stopped_word (who, m, info, "", false);
  if (! isempty (word))
    error ("gsmbp:stopped", "%s: %s: %s on the way %s at t = %.9g s; half of it is no result", ...
           who, m.name, gs.run.stopped_text (word), way, at);
  endif
endfunction

## the run as gsmbp_simulate gives it
function r = run_of (m, o, times, x)
  r.t = times(:);
  r.x = x;
  r.v = zeros (numel (r.t), m.sizes.nv);
  if (isstruct (o.input))
    t = r.t';   # at a jump a row has what was before it, but for the first one
    left = [false, ismember(t(2:end), o.input.breaks(2:end-1))];
    t(left) = gs.run.just_before (t(left));
    r.v = reshape (ppval (o.input, t), m.sizes.nv, [])';
  elseif (! isempty (o.input))
    r.v = repmat (o.input(:)', numel (r.t), 1);
  endif
  r.y = gs.run.output_values (m, gs.run.row_times (m, r.t), r.x, r.v);
endfunction

## of goals with three results, or two; anything else that goes wrong in them is the user's to see
function [J, gx, gy] = results (who, goal, r)
  wanted = sprintf ("%s: argument goal: expected a function [J, Jx, Jy] = goal (r)", who);
  if (! is_function_handle (goal))
    error ("%s, found %s", wanted, gs.text.shown_value (goal));
  endif
  gy = [];
  fewer = "nargin != nargout|too many outputs|undefined in return list|not enough";
  try
    [J, gx, gy] = goal (r);
  catch err
    if (isempty (regexp (err.message, fewer)))
      rethrow (err);
    endif
    try
      [J, gx] = goal (r);
    catch err
      if (isempty (regexp (err.message, fewer)))
        rethrow (err);
      endif
      error ("%s, or [J, Jx], found one with fewer results", wanted);
    end_try_catch
  end_try_catch
endfunction

function [J, gx, gy] = weights (who, m, r, goal)
  [J, gx, gy] = results (who, goal, r);
  J = J(:);
  n = numel (J);
  if (isempty (gx))
    gx = zeros (rows (r.x), columns (r.x), n);
  endif
  if (isempty (gy))
    gy = zeros (rows (r.y), columns (r.y), n);
  endif
  for one = {{"Jx", gx, r.x}, {"Jy", gy, r.y}}
    [name, given, of] = one{1}{:};
    if (! isequal ([size(given), 1](1:3), [size(of), n]))
      error ("%s: goal: expected %s of %d x %d x %d numbers, found %s", who, name, size (of), n, ...
             strjoin (cellstr (num2str (size (given)'))', " x "));
    endif
  endfor
endfunction

## weights of the states that a goal of states and outputs has at every time; what the outputs have
## of the parameters themselves
function [wx, wp] = at_outputs (m, r, gx, gy, np)
  wx = gx';
  wp = zeros (np, 1);
  t = gs.run.row_times (m, r.t);
  for i = find (any (gy, 2))'
    [~, ~, C] = m.jac (t(i), r.x(i,:)', r.v(i,:)');
    wx(:,i) += C' * gy(i,:)';
    wp += m.oup (t(i), r.x(i,:)', r.v(i,:)')' * gy(i,:)';
  endfor
endfunction

%!error <ADJ>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_adjoint (gsmbp_hand ("motor_pendulum"), [0; 0; 0], [0 1], @(r) deal (0, 0));
