## -*- texinfo -*-
## @deftypefn  {} {@var{r} =} gsmbp_trim (@var{m}, @var{x}, @var{v})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "hold", @var{names}, "free", @var{inputs}, "time", @var{t}, "tolerance", @var{tol})
## An equilibrium of a scene: a state at rest, with loops closed, in which
## nothing is accelerated.
##
## From the guess @var{x} (@var{nx} states, or the @var{nq} coordinates) and
## the inputs @var{v} (@var{nv}, zeros by default) of the model @var{m} all
## coordinates and actuator states are adjusted by Newton's method with the
## exact Jacobians; speeds are zero.  States named in "hold" keep their value,
## inputs named in "free" are adjusted as well.  @var{r} has the fields
## @code{x}, @code{v}, @code{ud} (accelerations that are left, zero to
## rounding), @code{lambda} (multipliers), @code{phi} and @code{residual} (the
## largest of rates and constraints).
##
## An equilibrium that is not found is an error that says what is left
## (above @var{tol}, default 1e-9, in SI units).
## @seealso{gsmbp_linear, gsmbp_assemble}
## @end deftypefn

function r = gsmbp_trim (m, x, v, varargin)
  if (nargin < 2 || ! isstruct (m))
    print_usage ();
  endif
  if (nargin < 3)
    v = [];
  endif
  who = "gsmbp_trim";
  d = m.sizes;
  o = gsmbp__options (who, struct ("hold", {{}}, "free", {{}}, "time", 0, "tolerance", 1e-9), varargin);
  if (! any (strcmp (m.subroutines, "jac")))
    error ("%s: %s was emitted without the subroutine JAC", who, m.name);
  endif
  x = [x(:); zeros(d.nx - numel (x), 1)];
  x(d.nq + (1:d.nu)) = 0;
  v = [v(:); zeros(d.nv - numel (v), 1)];
  held = places (who, o.hold, m.states, "hold", "a state");
  inputs = places (who, o.free, m.inputs, "free", "an input");
  own = setdiff ([1:d.nq, d.nq + d.nu + 1:d.nx], held);
  if (d.nlam > 0 || d.nq > d.nu)
    x = closed (m, x, held, o.time);
  endif
  [f, best] = residual (m, x, v, o.time);
  for k = 1:100
    if (best <= 1e-2 * o.tolerance)
      break;
    endif
    J = jacobian (m, x, v, o.time, own, inputs);
    step = - pinv (J, 1e-10 * norm (J)) * f;
    step *= min (1, 0.5 / max (abs ([step; eps])));
    for half = 1:12
      y = x;
      y(own) += step(1:numel (own));
      w = v;
      w(inputs) += step(numel (own) + 1:end);
      [g, next] = residual (m, y, w, o.time);
      if (norm (g) < norm (f))
        break;
      endif
      step /= 2;
    endfor
    if (! (norm (g) < norm (f)))
      break;
    endif
    [x, v, f, best] = deal (y, w, g, next);
  endfor
  if (! (best <= o.tolerance))
    error ("%s: %s: no equilibrium found near the guess: %g of the rates and constraints is left (tolerance %g); try another guess, or let inputs be free", who,
           m.name, best, o.tolerance);
  endif
  xd = m.rhs (o.time, x, v);
  r = struct ("x", x, "v", v, "ud", xd(d.nq + (1:d.nu)), "lambda", zeros (0, 1), "phi", zeros (0, 1), "residual", best);
  if (d.nlam > 0)
    [~, r.lambda] = m.acc (o.time, x, v);
    r.phi = m.con (o.time, x(1:d.nq), zeros (d.nu, 1));
  endif
endfunction

## accelerations, rates of actuator states, constraints, norms; they must be zero
function [f, largest] = residual (m, x, v, t)
  d = m.sizes;
  xd = m.rhs (t, x, v);
  f = xd(d.nq + 1:end);
  if (d.nlam > 0)
    f = [f; m.con(t, x(1:d.nq), zeros (d.nu, 1))];
  endif
  f = [f; norms(m, x)];
  largest = max ([abs(f); 0]);
  if (! all (isfinite (f)))
    f(:) = Inf;
    largest = Inf;
  endif
endfunction

function J = jacobian (m, x, v, t, own, inputs)
  d = m.sizes;
  [A, B] = m.jac (t, x, v);
  J = [A(d.nq + 1:end, own), B(d.nq + 1:end, inputs)];
  if (d.nlam > 0)
    P = [m.tan(t, x), zeros(d.nlam, d.nx - d.nq)];
    J = [J; P(:,own), zeros(d.nlam, numel (inputs))];
  endif
  [~, N] = norms (m, x);
  J = [J; N(:,own), zeros(rows (N), numel (inputs))];
endfunction

## squares of the Euler parameters less one, and their gradients
function [f, N] = norms (m, x)
  sets = m.orientation;
  f = zeros (rows (sets), 1);
  N = zeros (rows (sets), numel (x));
  for k = 1:rows (sets)
    f(k) = sum (x(sets(k,:)) .^ 2) - 1;
    N(k,sets(k,:)) = 2 * x(sets(k,:));
  endfor
endfunction

## a closed state with the held coordinates where they are, if that can be had
function x = closed (m, x, held, t)
  held = held(held <= m.sizes.nq);
  try
    if (isempty (held))
      x = gsmbp_assemble (m, x, "time", t);
    else
      x = gsmbp_assemble (m, x, "time", t, "hold", m.states(held));
    endif
  end_try_catch
endfunction

function k = places (who, names, all_names, option, what)
  if (ischar (names))
    names = {names};
  endif
  [found, k] = ismember (names, all_names);
  if (! all (found))
    error ("%s: option \"%s\": %s is not %s; expected one of %s", who, option, names{find (! found, 1)}, what, strjoin (all_names, ", "));
  endif
endfunction

%!test
%! addpath (fullfile (fileparts (fileparts (which ("gsmbp_build"))), "tests", "octave"));
%! m = gsmbp_hand ("motor_pendulum");
%! r = gsmbp_trim (m, [0.3; 0; 0], 0, "hold", m.states{1}, "free", m.inputs{1});
%! assert (r.x(1), 0.3);
%! assert (max (abs (m.rhs (0, r.x, r.v))) < 1e-9);
%!error <is not a state> gsmbp_trim (gsmbp_hand ("motor_pendulum"), [0;0;0], 0, "hold", "nobody")
