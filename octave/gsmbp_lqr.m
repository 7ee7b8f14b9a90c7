## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{design} =} gsmbp_lqr (@var{m}, @var{motion}, @var{times}, @var{Q}, @var{R})
## @deftypefnx {} {@var{design} =} gsmbp_lqr (..., "inputs", @var{names}, "design", @var{word})
## Linear state feedback that holds a scene about a planned motion.
##
## At each of the @var{times} [s] the exact linear model of the scene about the
## nominal states of the planned @var{motion} (@code{gsmbp_inverse}) is given
## to @code{lqr} of the control package with the weights @var{Q} (@var{nx} x
## @var{nx}) and @var{R} (@var{nv} x @var{nv}).  Of a closed chain the model in
## independent states is taken, and only these are fed back.  The gains are scheduled
## linearly between the times (two or more); one time gives a constant gain.
## "inputs": the @var{names} of the inputs that the control has, in the order of
## @var{R} (default: all of @code{m.inputs}); the others are disturbances, their
## gains are zero.
##
## "design": "frozen" (default), as above: each time as if the motion stood still there; "varying":
## the feedback that is best for the motion as a whole up to the last of the times, by Riccati's
## differential equation backwards from the weight "Qend" (@var{nx} x @var{nx}; default: what is
## left to come if the motion stood still at its end), in "steps" (default 20) between two times.
##
## @var{design} has the fields @code{gain} and @code{reference}, to be handed
## to @code{gsmbp_simulate} under these names together with "motion", and
## @code{poles}: the closed poles [1/s], a column for each time.
##
## @c session octave
## @example
## >> gsmbp_derive ("examples/puma560/puma560.mac", "fortran_out");
## ...
## >> m = gsmbp_build ("puma560");
## >> plan = gsmbp_plan ("quintic", [0.5 0; -0.75 0; 0.5 0], [0 1]);
## >> d = gsmbp_lqr (m, plan, [0 1], eye (9), eye (3));
## >> x = gsmbp_inverse (m, plan, 0).x';
## >> law = @{"motion", plan, "gain", d.gain, "reference", d.reference@};
## >> r = gsmbp_simulate (m, x, [0; 1], law@{:@});
## >> max (abs (r.x(end,1:3))) < 1e-3
## ans = 1
## @end example
##
## Errors: Q, R or Qend of another size; the control package missing; a motion that
## the scene cannot follow; a derivative that is not finite.
## Source: Riccati's equation, by lqr of the control package, at each time; along the motion by
## Magnus' method of order 4 on its Hamiltonian matrix; gains scheduled linearly.
## @seealso{gsmbp_linear, gsmbp_simulate, lqr}
## @end deftypefn

function design = gsmbp_lqr (m, motion, times, Q, R, varargin)
  if (nargin < 5)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_lqr", m);
  gs.given.refuse_words ("gsmbp_lqr", "motion", motion, "times", times);
  gs.given.check_kind ("gsmbp_lqr", "argument Q", Q, "numbers");
  gs.given.check_kind ("gsmbp_lqr", "argument R", R, "numbers");
  [Q, R] = deal (double (Q), double (R));
  d = m.sizes;
  [hands, o] = controlled (m, varargin);
  n = numel (hands);
  if (! isequal (size (Q), [d.nx d.nx]) || ! isequal (size (R), [n n]))
    error ("gsmbp_lqr: %s: expected Q as %d x %d and R as %d x %d; found %s and %s", m.name, ...
           d.nx, d.nx, n, n, gs.text.shown_value (size (Q)), gs.text.shown_value (size (R)));
  endif
  if (isempty (which ("lqr")))
    pkg load control
  endif
  times = gs.given.given_times ("gsmbp_lqr", times);
  nominal = gsmbp_inverse (m, motion, times);
  nt = numel (times);
  gains = zeros (nt, d.nv * d.nx);
  chosen = "auto";
  if (strcmp (o.design, "varying"))
    [gains, design] = varying (m, motion, times, hands, Q, R, o);
    nt = -nt;   # all is done
  endif
  for i = 1:nt
    [sys, T, states] = gsmbp_linear (m, times(i), nominal.x(i,:)', nominal.v(i,:)', "reduced", ...
                                     chosen);
    if (numel (states) < d.nx)
      chosen = m.states(states(states <= d.nq + d.nu));   # the same ones at all times
    endif
    ## balanced, so that currents and angles are numbers of like size; rounding errors must not take
    ## part
    A = sys.a;
    A(abs (A) < 1e-13 * max (abs (A(:)))) = 0;
    [S, ~] = balance (A);
    [K, ~, poles] = lqr (S \ A * S, (S \ sys.b)(:,hands), (T * S)' * Q * (T * S), R);
    all_states = zeros (d.nv, d.nx);
    all_states(hands,states) = K / S;
    gains(i,:) = all_states(:)';
    design.poles(:,i) = poles;
  endfor
  if (abs (nt) == 1)
    design.gain = reshape (gains, d.nv, d.nx);
  else
    design.gain = gsmbp_plan ("table", times, gains, 1);
  endif
  ## the states along the motion, close enough that the spline between them does not matter
  breaks = motion.breaks;
  fine = unique ([linspace(breaks(1), breaks(end), 401), breaks]);
  design.reference = gsmbp_plan ("table", fine, gsmbp_inverse (m, motion, fine).x, 3);
endfunction

## the feedback that is best along the motion up to its end: Riccati's differential equation
function [gains, design] = varying (m, motion, times, hands, Q, R, o)
  d = m.sizes;
  if (numel (times) < 2)
    error ("gsmbp_lqr: option design: \"varying\" needs two times or more, found %d", ...
           numel (times));
  endif
  last = linear_at (m, motion, times(end), hands, "auto");
  chosen = last.chosen;
  if (isempty (o.Qend))
    [~, P] = gs.control.riccati_solution ("gsmbp_lqr", last.A, last.B, last.T' * Q * last.T, R, 0);
  else
    Qend = gs.given.weight_matrix ("gsmbp_lqr", "Qend", o.Qend, d.nx, 0);
    P = last.T' * Qend * last.T;
  endif
  P = gs.control.riccati_along (@(t) matrices (m, motion, t, hands, chosen, Q, R), times, ...
                                o.steps, P);
  gains = zeros (numel (times), d.nv * d.nx);
  at = linear_at (m, motion, times, hands, chosen);
  for i = 1:numel (times)
    K = zeros (d.nv, d.nx);
    K(hands,at(i).states) = R \ (at(i).B' * P(:,:,i));
    gains(i,:) = K(:)';
    design.poles(:,i) = eig (at(i).A - at(i).B * K(hands,at(i).states));
  endfor
endfunction

## rows of A, B R^-1 B', Q at the times
function parts = matrices (m, motion, t, hands, chosen, Q, R)
  at = linear_at (m, motion, t, hands, chosen);
  parts = cell (numel (t), 3);
  for k = 1:numel (t)
    parts(k,:) = {at(k).A, at(k).B / R * at(k).B', at(k).T' * Q * at(k).T};
  endfor
endfunction

## linear models about the motion at the times
function list = linear_at (m, motion, times, hands, chosen)
  nominal = gsmbp_inverse (m, motion, times);
  for i = 1:numel (times)
    [sys, T, states] = gsmbp_linear (m, times(i), nominal.x(i,:)', nominal.v(i,:)', "reduced", ...
                                     chosen);
    if (numel (states) < m.sizes.nx)
      chosen = m.states(states(states <= m.sizes.nq + m.sizes.nu));
    endif
    [A, B] = ssdata (sys);
    list(i) = struct ("A", A, "B", B(:,hands), "T", T, "states", states, "chosen", {chosen});
  endfor
endfunction

## the numbers of the inputs that the control has, and the options
function [k, o] = controlled (m, options)
  table = {"inputs", {}, "names"; "design", "frozen", {"frozen", "varying"}
           "Qend", [], "numbers"; "steps", 20, "whole"};
  o = gs.given.call_options ("gsmbp_lqr", table, options);
  names = o.inputs;
  if (isempty (names))
    k = 1:m.sizes.nv;
    if (isempty (k))
      error ("gsmbp_lqr: argument m: expected a model with inputs; found none in %s", m.name);
    endif
    return;
  endif
  names = cellstr (names);
  k = vec (gs.given.places_of (names, m.inputs), 2);
  if (! all (k))
    error ("gsmbp_lqr: option \"inputs\": expected the name of an input, found %s", ...
           gs.text.nearest_word (names{find (! k, 1)}, m.inputs));
  endif
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! plan = gsmbp_plan ("septic", [0 2], [0 1]);
%! d = gsmbp_lqr (m, plan, 0:0.25:1, diag ([100 1 0]), 0.01);
%! assert (all (real (d.poles(:)) < 0));
%! start = gsmbp_inverse (m, plan, 0).x' + [0.1; 0; 0];
%! r = gsmbp_simulate (m, start, [0 1], "motion", plan, "gain", d.gain, "reference", d.reference);
%! assert (r.x(2,1), 2, 5e-3);
%! same = gsmbp_lqr (m, plan, 0:0.25:1, diag ([100 1 0]), 0.01, "inputs", m.inputs{1});
%! assert (same.poles, d.poles);
%!testif ; ! isempty (pkg ("list", "control"))   # along a motion: at rest a matrix exponential
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! still = gsmbp_plan ("quintic", [0.3 0.3], [0 1]);
%! [Q, R, E] = deal (diag ([100 1 0.1]), 0.5, diag ([3 2 0]));
%! d = gsmbp_lqr (m, still, [0 0.004 0.01], Q, R, "design", "varying", "Qend", E);
%! n = gsmbp_inverse (m, still, 0);
%! [A, B] = m.jac (0, n.x', n.v');
%! X = expm (-0.006 * [A, -B*(R\B'); -Q, -A']) * [eye(3); E];
%! P = X(4:6,:) / X(1:3,:);
%! assert (reshape (ppval (d.gain, 0.004), 1, 3), R \ B' * P, 1e-10);
%! P = E;
%! assert (reshape (ppval (d.gain, 0.01), 1, 3), R \ B' * P, 1e-12);
%! move = gsmbp_plan ("septic", [0 2], [0 1]);   # order 4 where the model changes
%! K = cell (1, 3);
%! for k = 1:3
%!   d = gsmbp_lqr (m, move, [0.6 0.65 0.7], Q, R, "design", "varying", "Qend", E, "steps", ...
%!                  [8, 16, 32](k));
%!   K{k} = ppval (d.gain, 0.6);
%! endfor
%! assert (norm (K{1} - K{3}) > 8 * norm (K{2} - K{3}));
%! assert (norm (K{2} - K{3}) < 1e-5 * norm (K{3}));
%!error <expected the name of an input, found "nobody"; known: >
%! gsmbp_lqr (gsmbp_hand ("motor_pendulum"), [], 0, eye (3), 1, "inputs", "nobody")
%!error <expected Q as 3 x 3> gsmbp_lqr (gsmbp_hand ("motor_pendulum"), [], 0, 1, 1)
