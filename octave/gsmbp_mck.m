## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{r} =} gsmbp_mck (@var{m}, @var{t}, @var{x}, @var{v})
## @deftypefnx {} {@var{r} =} gsmbp_mck (@dots{}, "reduced", @var{names}, "drop", @var{names})
## The matrices of small motions about an equilibrium or a steady motion:
## M u' + C u + K q = B v + E z.
##
## @var{u} and @var{q} are deviations of the independent speeds and coordinates at the state @var{x}
## of the model @var{m}, @var{v} of the inputs, @var{z} of the states of devices.  All of it is
## exact: M is the mass matrix with the inertia of devices on the directions that the constraints
## leave, C and K are it times the exact Jacobians of the accelerations (@code{gsmbp_linear}), with
## what multipliers and speeds of a steady motion (gyroscopic and centrifugal terms) bring.
## Arguments and options are those of @code{gsmbp_linear}: @code{"reduced"}, @code{"drop"}.
##
## @var{r} has the fields
## @table @code
## @item M, C, K, B, E
## the matrices [SI]; a row for each independent speed
## @item D, G
## damping and gyroscopic part of C = D + G: symmetric and skew
## @item S, N
## conservative and circulatory part of K = S + N, where coordinates and speeds go in pairs, else
## empty
## @item coordinates, speeds, inputs, devices
## names of q, u, v, z: columns of K, M and C, B, E
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> x = gsmbp_assemble (m, [-pi/2; 1; 0.4], "hold", "q1");
## >> r = gsmbp_trim (m, x, 0, "hold", "q1", "free", "motor.v");
## >> k = gsmbp_mck (m, 0, r.x, r.v, "reduced", "q1");
## >> [k.M, k.C, k.K]
## ans =
##
##    0.2000   0.3268   2.9430
## @end example
##
## Errors: those of @code{gsmbp_linear}; a model without the subroutine MAS.
## Source: own: M on the constraints' tangent space, times the exact Jacobians.
## @seealso{gsmbp_linear, gsmbp_trim, gsmbp_modes}
## @end deftypefn

function r = gsmbp_mck (m, t, x, v, varargin)
  if (nargin < 3)
    print_usage ();
  endif
  who = "gsmbp_mck";
  gs.given.check_model (who, m);
  gs.given.check_moving (who, m);
  if (! any (strcmp (m.subroutines, "mas")))
    error ("%s: %s was emitted without the subroutine MAS: add the request mass", who, m.name);
  endif
  if (nargin < 4)
    v = [];
  endif
  gs.given.refuse_words (who, "t", t, "x", x, "v", v);
  x = gs.start.consistent_start (who, m, gs.given.given_vector (who, "t", t, 1), x, "check");
  [sys, T, k] = gsmbp_linear (m, t, x, v, varargin{:});
  d = m.sizes;
  q = k <= d.nq;
  u = k > d.nq & k <= d.nq + d.nu;
  z = k > d.nq + d.nu;
  V = T(d.nq + (1:d.nu),u);
  r.M = V' * m.mas (t, x(1:d.nq)) * V;
  r.M = (r.M + r.M') / 2;
  r.C = -r.M * sys.a(u,u);
  r.K = -r.M * sys.a(u,q);
  r.B = r.M * sys.b(u,:);
  r.E = r.M * sys.a(u,z);
  r.D = (r.C + r.C') / 2;
  r.G = (r.C - r.C') / 2;
  [r.S, r.N] = deal ([]);
  r.coordinates = m.states(k(q));
  r.speeds = m.states(k(u));
  if (d.nq == d.nu && isequal (k(q) + d.nq, k(u)))
    r.S = (r.K + r.K') / 2;
    r.N = (r.K - r.K') / 2;
  endif
  r.inputs = m.inputs;
  r.devices = m.states(k(z));
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! r = gsmbp_mck (m, 0, [0.3 0 0], 0);
%! A = m.jac (0, [0.3; 0; 0], 0);
%! assert (r.M \ [-r.K, -r.C, r.E], A(2,:), 1e-12);
%! assert (r.devices, m.states(3));
%!error <Invalid call> gsmbp_mck (1)
