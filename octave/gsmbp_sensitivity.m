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
  [dx, dv] = at_rest (who, m, o, x, v);
  dy = of_outputs (m, o.time, x, v, dx, dv);
  s.names = cellstr (m.json.sensitivity)(:)';
  [s.poles, dp, w, dw, z, dz] = of_poles (who, m, o.time, x, v, dx, dv, s.names);
  s.frequency = w;
  s.damping = z;
  parts = struct ("dx", dx, "dv", dv, "dy", dy, "dpoles", dp, "dfrequency", dw, "ddamping", dz);
  for part = fieldnames (parts)'
    s.(part{1}) = cell2struct (num2cell (parts.(part{1}), 1)(:), s.names(:), 1);
  endfor
endfunction

## derivatives of the equilibrium: rates of speeds and devices stay zero, the loops closed
function [dx, dv] = at_rest (who, m, o, x, v)
  d = m.sizes;
  hold_ = numbers (who, "hold", o.hold, m.states);
  free = numbers (who, "free", o.free, m.inputs);
  [P, A, B, rates] = m.rhp (o.time, x, v);
  gs.given.need_derivatives ([who, ": ", m.name], [A, B, P], ...
                             strcat ({"rate of "}, m.states(:)), ...
                             [m.states(:); m.inputs(:); cellstr(m.json.sensitivity)(:)]);
  if (any (x(d.nq+(1:d.nu))) || ! (max (abs (rates ./ m.nominal)) < 1e-6))
    error ("%s: %s: expected an equilibrium, as gsmbp_trim finds it; found rates up to %.3g", ...
           who, m.name, max (abs (rates ./ m.nominal)));
  endif
  k = setdiff ([1:d.nq, d.nq+d.nu+1:d.nx], hold_);
  E = [A(d.nq+1:end,k), B(d.nq+1:end,free)];
  r = -P(d.nq+1:end,:);
  if (d.nlam > 0)
    DP = [m.tan(o.time, x), zeros(d.nlam, d.nx - d.nq)];
    E = [E; DP(:,k), zeros(d.nlam, numel (free))];
    r = [r; -m.cop(o.time, x)];
  endif
  for set = m.orientation'
    row = zeros (1, d.nx);
    row(set) = x(set);
    E = [E; row(k), zeros(1, numel (free))];
    r = [r; zeros(1, columns (P))];
  endfor
  scale = [m.nominal(k); ones(numel (free), 1)]';
  z = alone (who, m, E .* scale, r, [m.states(k); m.inputs(free)]) .* scale';
  dx = zeros (d.nx, columns (P));
  dv = zeros (d.nv, columns (P));
  dx(k,:) = z(1:numel (k),:);
  dv(free,:) = z(numel (k)+1:end,:);
endfunction

## the solution of E*z = r, or an error where it is not the only one, or none
function z = alone (who, m, E, r, names)
  big = max (abs (E), [], 2);
  big(big == 0) = 1;
  E ./= big;
  r ./= big;
  N = null (E, 1e-9);
  if (! isempty (N))
    error (["%s: %s: the equilibrium does not stand alone: %s can be moved; hold some of them " ...
            "(\"hold\")"], who, m.name, strjoin (names(max (abs (N), [], 2) > 1e-6)', ", "));
  endif
  z = E \ r;
  if (norm (E * z - r, Inf) > 1e-8 * max (1, norm (r, Inf)))
    error (["%s: %s: with other parameters there is no equilibrium near this one; free an " ...
            "input (\"free\")"], who, m.name);
  endif
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

function dy = of_outputs (m, t, x, v, dx, dv)
  dy = NaN (m.sizes.ny, columns (dx));
  if (m.sizes.ny > 0 && any (strcmp (m.subroutines, "oup")))
    [~, ~, C, D] = m.jac (t, x, v);
    dy = C * dx + D * dv + m.oup (t, x, v);
  endif
endfunction

## poles, and their derivatives by perturbation; frequencies and damping of those that oscillate
function [e, de, w, dw, z, dz] = of_poles (who, m, t, x, v, dx, dv, names)
  [~, free] = gs.linear.loop_tangent (who, m, t, x, []);
  reduced = @(m, x, v) m.jac (t, x, v)(free,:) ...
                       * gs.linear.loop_tangent (who, m, t, x, free);
  [V, e, W] = eig (reduced (m, x, v), "vector");
  [~, order] = sort (abs (e));
  [V, e, W] = deal (V(:,order), e(order), W(:,order));
  de = zeros (numel (e), numel (names));
  for k = 1:numel (names)
    dA = along (m, reduced, x, v, dx(:,k), dv(:,k), names{k});
    for i = 1:numel (e)
      touch = W(:,i)' * V(:,i);
      de(i,k) = (W(:,i)' * dA * V(:,i)) / touch;
      if (abs (touch) < 1e-6 * norm (W(:,i)) * norm (V(:,i)) || multiple (e, i))
        de(i,k) = NaN;
      endif
    endfor
  endfor
  up = imag (e) > 0;
  w = abs (e(up));
  dw = real (conj (e(up)) .* de(up,:)) ./ w;
  z = -real (e(up)) ./ w;
  dz = (-real (de(up,:)) - z .* dw) ./ w;
endfunction

function is = multiple (e, i)
  others = e([1:i-1, i+1:end]);
  is = any (abs (others - e(i)) <= 1e-9 * max (abs (e)));
endfunction

## the derivative of a function of model, states and inputs along a family of equilibria
function D = along (m, f, x, v, dx, dv, name)
  p = m.par.(name);
  h = 1e-2 * (abs (p) + (p == 0));
  h /= max ([1; h * abs(dx) ./ (1e-2 * m.nominal)]);
  g = @(s) f (gsmbp_set (m, name, p + s * h), x + s * h * dx, v + s * h * dv);
  D = (45 * (g (1) - g (-1)) - 9 * (g (2) - g (-2)) + (g (3) - g (-3))) / (60 * h);
endfunction

%!error <without the subroutine RHP>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_sensitivity (gsmbp_hand ("motor_pendulum"), [0; 0; 0]);
