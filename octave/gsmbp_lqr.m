## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{design} =} gsmbp_lqr (@var{m}, @var{motion}, @var{times}, @var{Q}, @var{R})
## @deftypefnx {} {@var{design} =} gsmbp_lqr (..., "inputs", @var{names})
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
## Errors: Q or R of another size; the control package missing; a motion that
## the scene cannot follow.
## Source: Riccati's equation, by lqr of the control package, at each time;
## gains scheduled linearly.
## @seealso{gsmbp_linear, gsmbp_simulate, lqr}
## @end deftypefn

function design = gsmbp_lqr (m, motion, times, Q, R, varargin)
  if (nargin < 5)
    print_usage ();
  endif
  gsmbp__model ("gsmbp_lqr", m);
  gsmbp__fits ("gsmbp_lqr", "argument Q", Q, "numbers");
  gsmbp__fits ("gsmbp_lqr", "argument R", R, "numbers");
  [Q, R] = deal (double (Q), double (R));
  d = m.sizes;
  hands = controlled (m, varargin);
  n = numel (hands);
  if (! isequal (size (Q), [d.nx d.nx]) || ! isequal (size (R), [n n]))
    error ("gsmbp_lqr: %s: expected Q as %d x %d and R as %d x %d; found %s and %s", m.name, ...
           d.nx, d.nx, n, n, gsmbp__shown (size (Q)), gsmbp__shown (size (R)));
  endif
  if (isempty (which ("lqr")))
    pkg load control
  endif
  times = gsmbp__times ("gsmbp_lqr", times);
  nominal = gsmbp_inverse (m, motion, times);
  nt = numel (times);
  gains = zeros (nt, d.nv * d.nx);
  chosen = "auto";
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
  if (nt == 1)
    design.gain = reshape (gains, d.nv, d.nx);
  else
    design.gain = gsmbp_plan ("table", times, gains, 1);
  endif
  ## the states along the motion, close enough that the spline between them does not matter
  breaks = motion.breaks;
  fine = unique ([linspace(breaks(1), breaks(end), 401), breaks]);
  design.reference = gsmbp_plan ("table", fine, gsmbp_inverse (m, motion, fine).x, 3);
endfunction

## the numbers of the inputs that the control has
function k = controlled (m, options)
  table = {"inputs", {}, "names"};
  names = gsmbp__options ("gsmbp_lqr", table, options).inputs;
  if (isempty (names))
    k = 1:m.sizes.nv;
    return;
  endif
  names = cellstr (names);
  k = gsmbp__which (names, m.inputs)(:)';
  if (! all (k))
    error ("gsmbp_lqr: option \"inputs\": expected the name of an input, found %s", ...
           gsmbp__unknown (names{find (! k, 1)}, m.inputs));
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
%!error <expected the name of an input, found "nobody"; known: >
%! gsmbp_lqr (gsmbp_hand ("motor_pendulum"), [], 0, eye (3), 1, "inputs", "nobody")
%!error <expected Q as 3 x 3> gsmbp_lqr (gsmbp_hand ("motor_pendulum"), [], 0, 1, 1)
