## -*- texinfo -*-
## @c category Linear models and control
## @deftypefn  {} {@var{s} =} gsmbp_sensitivity (@var{m}, @var{x}, @var{v})
## @deftypefnx {} {@var{s} =} gsmbp_sensitivity (@dots{}, "hold", @var{names}, "free", @var{inputs})
## @deftypefnx {} {@var{s} =} gsmbp_sensitivity (@dots{}, "time", @var{t})
## How an equilibrium, its poles and its frequencies change with parameters.
##
## @var{x}, @var{v} are an equilibrium of the model @var{m}, as @code{gsmbp_trim} finds it, with the
## same words "hold" (states that keep their value) and "free" (inputs that follow).  The parameters
## are those that the scene was derived for (request @code{sensitivity(m1, k)} of
## @code{gsmbp_fortran}).
##
## @var{s} has the fields
## @table @code
## @item names
## of the parameters
## @item dx, dv, dy
## structs by these names: derivatives of the states, the inputs and the outputs of the
## equilibrium, columns; exact to rounding (one linear system with m.rhp)
## @item poles
## of the linear model in independent states [1/s], sorted by their size
## @item dpoles
## a struct by the names: their derivatives along the family of equilibria, columns; NaN where a
## pole is a multiple one, which has none.  The exact Jacobian is differentiated along dx, dv by
## differences of order 6: some ten digits
## @item frequency, dfrequency, damping, ddamping
## of the poles with positive imaginary part: absolute value [rad/s], damping ratio
## @end table
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
## >> e = gsmbp_trim (m, [0.3; 0], 0, "hold", "q", "free", "tau");
## >> s = gsmbp_sensitivity (m, e.x, e.v, "hold", "q", "free", "tau");
## >> [s.dv.m, s.dv.l]
## ans =
##
##     4.6859   18.7437
## @end example
##
## Errors: a state that is no equilibrium, or one that does not stand alone (the states that can be
## moved are named); a derivative that is not finite; a model without RHP; unknown names.
## Source: own: the implicit function theorem on the equations of motion; perturbation of
## eigenvalues.
## @seealso{gsmbp_trim, gsmbp_linear, gsmbp_modes, gsmbp_simulate}
## @end deftypefn

function s = gsmbp_sensitivity (m, x, v, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_sensitivity";
  gs.given.check_model (who, m);
  if (nargin < 3 || isempty (v))
    v = zeros (m.sizes.nv, 1);
  endif
  gs.given.refuse_words (who, "x", x, "v", v);
  table = {"hold", {}, "names"
           "free", {}, "names"
           "time", 0, "number"};
  o = gs.given.call_options (who, table, varargin);
  if (! all (ismember ({"rhp", "jac"}, m.subroutines)))
    error (["%s: %s was emitted without the subroutine RHP: derive it with the request " ...
            "sensitivity(p, ...) of gsmbp_fortran"], who, m.name);
  endif
  x = gs.start.consistent_start (who, m, o.time, x, "check");
  v = gs.given.given_vector (who, "v", v, m.sizes.nv, " (the inputs)", m.inputs);
  names = cellstr (m.json.sensitivity)(:)';
  at = gs.linear.state_place (m, o.time, x, v);
  [verdict, text, dx, dv, dy] = m.module ("rest slopes", at{:}, ...
                                          numbers (who, "hold", o.hold, m.states), ...
                                          numbers (who, "free", o.free, m.inputs), names(:));
  gs.linear.heed_verdict (who, m, verdict, text);
  [s, V, W, reduced] = gs.linear.state_poles (who, m, o.time, x, v);
  s.names = names;
  [dp, dw, dz] = of_poles (m, s.poles, V, W, reduced, x, v, dx, dv, names);
  parts = struct ("dx", dx, "dv", dv, "dy", dy, "dpoles", dp, "dfrequency", dw, "ddamping", dz);
  for part = fieldnames (parts)'
    s.(part{1}) = cell2struct (num2cell (parts.(part{1}), 1)(:), names(:), 1);
  endfor
endfunction

function k = numbers (who, option, names, known)
  names = cellstr (names)(:)';
  if (isequal (names, {""}))
    names = {};
  endif
  k = gs.given.places_of (names, known);
  if (! all (k))
    error ("%s: option \"%s\": unknown name %s", who, option, ...
           gs.text.nearest_word (names{find (! k, 1)}, known));
  endif
endfunction

## derivatives of the poles by perturbation, of frequencies and damping of those that oscillate
function [de, dw, dz] = of_poles (m, e, V, W, reduced, x, v, dx, dv, names)
  [de, dw, dz] = deal (zeros (numel (e), numel (names)));
  for k = 1:numel (names)
    dA = along (m, reduced, x, v, dx(:,k), dv(:,k), names{k});
    [de(:,k), dw(:,k), dz(:,k)] = m.module ("pole slopes", e, V, W, dA);
  endfor
  up = imag (e) > 0;
  [dw, dz] = deal (dw(up,:), dz(up,:));
endfunction

## the derivative of a function of model, states and inputs along a family of equilibria
function D = along (m, f, x, v, dx, dv, name)
  p = m.par.(name);
  [steps, factors] = m.module ("family steps", m.nominal, p, dx);
  D = 0;
  for k = 1:numel (steps)
    s = steps(k);
    D += factors(k) * f (gsmbp_set (m, name, p + s), x + s * dx, v + s * dv);
  endfor
endfunction

%!error <without the subroutine RHP>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_sensitivity (gsmbp_hand ("motor_pendulum"), [0; 0; 0]);
