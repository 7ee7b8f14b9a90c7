## -*- texinfo -*-
## @deftypefn {} {@var{sys} =} gsmbp_linear (@var{m}, @var{t}, @var{x}, @var{v})
## The exact linear model of a scene as an @code{ss} object of the control
## package, with StateName, InputName and OutputName.
##
## The model @var{m} (of @code{gsmbp_build}) is linearized at the time @var{t}
## [s], the @var{nx} states @var{x} and the @var{nv} inputs @var{v} (zeros by
## default): deviations obey dx' = A dx + B dv, dy = C dx + D dv.  Where the
## scene has no outputs they are its states.
## @seealso{gsmbp_build, ss, lqr}
## @end deftypefn

function sys = gsmbp_linear (m, t, x, v)
  if (nargin < 3 || ! isstruct (m))
    print_usage ();
  endif
  if (! isfield (m, "jac"))
    error ("gsmbp_linear: %s was emitted without the subroutine JAC", m.name);
  endif
  if (nargin < 4)
    v = zeros (m.sizes.nv, 1);
  endif
  if (isempty (which ("ss")))
    pkg load control
  endif
  [A, B, C, D] = m.jac (t, x, v);
  outputs = m.outputs;
  if (m.sizes.ny == 0)
    C = eye (m.sizes.nx);
    D = zeros (m.sizes.nx, m.sizes.nv);
    outputs = m.states;
  endif
  sys = ss (A, B, C, D, "StateName", m.states, "InputName", m.inputs, "OutputName", outputs);
endfunction

%!testif ; ! isempty (pkg ("list", "control"))
%! addpath (fullfile (fileparts (fileparts (which ("gsmbp_build"))), "tests", "octave"));
%! m = gsmbp_hand ("motor_pendulum");
%! sys = gsmbp_linear (m, 0, [0 0 0], 0);
%! assert (get (sys, "stname"), m.states);
%! assert (get (sys, "inname"), m.inputs);
%! assert (sys.a(2,1), -1.2 * 9.81 * 0.5 / 0.32, 1e-13);
%! assert (columns (lqr (sys, eye (3), 1)), 3);
%!error gsmbp_linear ()
