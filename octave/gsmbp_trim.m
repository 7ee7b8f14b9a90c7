## -*- texinfo -*-
## @c category Positions and equilibria
## @deftypefn  {} {@var{r} =} gsmbp_trim (@var{m}, @var{x}, @var{v})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "hold", @var{names}, "free", @var{inputs})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "time", @var{t}, "tolerance", @var{tol})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "steady", @var{names})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "margins", @var{word})
## An equilibrium of a scene: a state at rest, with loops closed, in which
## nothing is accelerated; or a steady motion.
##
## From the guess @var{x} (@var{nx} states, or the @var{nq} coordinates: the
## states of the devices then start as the scene says) and the inputs @var{v}
## (@var{nv}, zeros by default) of the model @var{m} all coordinates and states
## of devices are adjusted by Newton's method with the exact Jacobians; speeds
## are zero.  States named in "hold" keep their value, inputs named in "free"
## are adjusted as well.  What a sampled device holds is an input here.
## A scene with events has a Jacobian with the request sensitivity alone, at the modes that
## @var{v} holds (0: a port holds, the default; -1 or 1: it slips); else it is refused.
##
## With "steady" the coordinates @var{names} run on at the constant speeds that @var{x} has for
## them: a motor at speed, a wheel that rolls straight on or in a circle, a top's precession.
## Coordinates that a motion of the scene drives (@code{motion = W*t}) run on with the time.  The
## other coordinates are at rest, but for those on which nothing depends (the place of what rolls).
## Speeds named in "free" are adjusted as well, "hold" may name a coordinate that would be.  The
## independent speeds are constant, dependent ones follow; that it stays so while the coordinates
## run on is checked.
##
## States count by their usual sizes (@code{m.nominal}), and the iteration goes
## on as long as the equations gain digits.  An equilibrium is one where every
## rate is below @var{tol} (default 1e-9) times the usual size of its state in a
## second, every constraint below @var{tol}, or where rounding of the terms
## hides the rest.
##
## @var{r} has the fields @code{x}, @code{v}, @code{running} (names of coordinates that run),
## @code{ud} (accelerations that are left, zero to rounding; of steady motions those of dependent
## speeds need not be), @code{lambda} (multipliers), @code{unique} (which
## of them the equilibrium determines), @code{phi},
## @code{residual} (the largest of rates and constraints, of these sizes),
## @code{way} ("newton", "levenberg" or "transient": what was needed) and
## @code{indifferent}: names of the states and free inputs that can be moved
## without leaving the equilibrium; it is empty for one that stands alone.
##
## An equilibrium that is not found is an error that names the equations that
## do not vanish, and inputs that could make them; so is a constraint that
## moves with time, and one in which a margin of a device is below 0 (a cylinder out of
## its stroke, a pressure below the tank's; @code{m.state_margins}), unless "margins",
## "ignore" is given.  One that holds at the time @var{t} only (default 0) is a
## warning.  Of several equilibria the one near the guess is found.
##
## @c session octave
## @example
## >> m = gsmbp_build ("slider_crank");
## >> r = gsmbp_trim (m, m.initial, 0, "hold", "q1", "free", "motor.v");
## >> r.v, r.residual < 1e-12
## ans = 1.0326
## ans = 1
## @end example
##
## Errors: no equilibrium or steady motion is found (the equations that do not vanish are
## named); a derivative that is not finite; one that is steady at an instant alone; a
## constraint that moves with time; a margin of a device below 0; an unknown name in "hold" or
## "free".
## Source: own: Newton's method with the exact Jacobians, Levenberg's and a
## transient where it fails.
## @seealso{gsmbp_linear, gsmbp_assemble}
## @end deftypefn

function r = gsmbp_trim (m, x, v, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  gs.given.check_model ("gsmbp_trim", m);
  if (nargin < 3)
    v = [];
  endif
  gs.given.refuse_words ("gsmbp_trim", "x", x, "v", v);
  table = {"hold", {}, "names"
           "free", {}, "names"
           "steady", {}, "names"
           "time", 0, "number"
           "tolerance", 1e-9, "tolerance"
           "margins", "check", {"check", "ignore"}};
  o = gs.given.call_options ("gsmbp_trim", table, varargin);
  p = gs.linear.rest_problem (m, x, v, o);
  check_rest (p, p.z);
  check_derivatives (p, p.z);
  [z, way] = gs.linear.rest_solve (p);
  check_rest (p, z);
  if (! (gs.linear.rest_worst (p, z) <= 1))
    gs.linear.rest_refuse (p, z);
  endif
  check_derivatives (p, z);
  free = spaces (p, z);
  [p, z] = nearest (p, z, free);
  check_time (p, z);
  r = result (p, z, way);
  r.unique = m.unique.multipliers';
  if (strcmp (o.margins, "check"))
    check_margins (p, r);
  endif
  r.indifferent = unknowns (p)(max (abs (free), [], 2) > 1e-6)(:)';
endfunction

## where the equilibrium does not stand alone: the one with as many unknowns as can be left as
## in the guess: states that nothing drives (an integrator without gain), then coordinates
function [p, z] = nearest (p, z, free)
  keep = [];
  first = undriven (p, z);
  for k = [first, setdiff(1:rows (free), first)]
    if (rank (free([keep, k],:), 1e-6) > numel (keep))
      keep(end+1) = k;
    endif
  endfor
  if (isempty (keep))
    return;
  endif
  q = p;
  q.fixed = keep;
  y = gs.linear.rest_newton (q, merge (ismember ((1:numel (z))', keep), p.z, z));
  if (gs.linear.rest_worst (p, y) <= 1)
    [p, z] = deal (q, y);
  endif
endfunction

## unknowns that are states of devices whose rates depend on nothing that may change
function k = undriven (p, z)
  [~, J] = gs.linear.rest_equations (p, z);
  own = p.own(:)';
  device = find (own > p.m.sizes.nq + p.m.sizes.nu);
  [~, row] = ismember (own(device), p.rows);
  k = device(! any (J(row,:), 2)');
endfunction

## what Newton's method needs
function check_derivatives (p, z)
  [~, J] = gs.linear.rest_equations (p, z);
  gs.given.need_derivatives ([p.who, ": ", p.m.name], J, gs.text.rest_names (p), unknowns (p));
endfunction

## with all speeds zero no constraint may move, nor begin to
function check_rest (p, z)
  d = p.m.sizes;
  if (d.nlam == 0 || ! isempty (p.steady))
    return;
  endif
  x = gs.linear.rest_state (p, z);
  [~, phit, ~, gam, ~] = p.m.con (p.t, x(1:d.nq), zeros (d.nu, 1));
  for found = {phit, -gam; "moves at %g", "starts with an acceleration of %g"; "/s", "/s^2"}
    k = find (! (abs (found{1}) <= p.tolerance), 1);
    if (! isempty (k))
      rate = sprintf ([found{2} "%s%s"], found{1}(k), gs.text.constraint_unit (p.m, k), found{3});
      error (["%s: %s: no state at rest at t = %g s: with all speeds zero the constraint %s " ...
              "%s, " ...
              "it is driven with time; take a time at which it rests (option \"time\"), or let " ...
              "the driven coordinate run on (option \"steady\")"],
             p.who, p.m.name, p.t, p.m.multipliers{k}, rate);
    endif
  endfor
endfunction

## no device may be where its laws do not hold
function check_margins (p, r)
  list = gs.start.range_margins (p.m, p.t, r.x', r.v');
  if (isempty (list))
    return;
  endif
  error ("gsmbp:margin",
         ["%s: %s: an equilibrium was found, but a device cannot be there: %s; try another " ...
          "guess, or take it as it is: \"margins\", \"ignore\""],
         p.who, p.m.name, strjoin ({list.said}, "; "));
endfunction

## the same state some other times
function check_time (p, z)
  if (! isempty (p.steady))
    gs.linear.steady_check (p, z);
    return;
  endif
  [f, J] = gs.linear.rest_equations (p, z);
  limit = max (p.tolerance * p.usual, 1e3 * eps * (abs (J) * max (abs (z), p.size)));
  for later = [0.618, 3.7, 19.1]
    k = find (! (abs (gs.linear.rest_equations (p, z, p.t + later)) <= 10 * limit), 1);
    if (! isempty (k))
      names = gs.text.rest_names (p);
      warning ("gsmbp:trim", "%s: %s: an equilibrium at t = %g s alone: %s changes with time",
               p.who, p.m.name, p.t, names{k});
      return;
    endif
  endfor
endfunction

function r = result (p, z, way)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = gs.linear.rest_state (p, z);
  xd = m.rhs (p.t, x, v);
  f = gs.linear.rest_equations (p, z);
  r = struct ("x", x, "v", v, "ud", xd(d.nq + (1:d.nu)), "lambda", zeros (0, 1), ...
              "phi", zeros (0, 1), "residual", max ([abs(f) ./ p.usual; 0]), "way", way, ...
              "running", {names_of(p, xd)});
  if (d.nlam > 0)
    [~, r.lambda] = m.acc (p.t, x, v);
    r.phi = m.con (p.t, x(1:d.nq), zeros (d.nu, 1));
  endif
endfunction

## coordinates that run
function names = names_of (p, xd)
  k = p.running;
  names = p.m.coordinates(k(abs (xd(k)) > 1e-12 * p.m.nominal(k)))(:)';
endfunction

## what can be moved without effect on the equations: an orthonormal basis, in units of the
## usual sizes
function free = spaces (p, z)
  [~, J] = gs.linear.rest_equations (p, z);
  row = abs (J) * p.size;
  row(! (row > 1e-20 * max ([row; 0]))) = 1;   # a row of noise is none
  [~, S, V] = svd (J .* p.size' ./ row);
  s = diag (S)(1:min (size (S)));
  free = V(:,sum (s > 1e-12 * max ([s; realmin])) + 1:end);
endfunction

function names = unknowns (p)
  names = [p.m.states(p.own)(:); p.m.inputs(p.inputs)(:)];
endfunction

%!test
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! m = gsmbp_hand ("motor_pendulum");
%! r = gsmbp_trim (m, [0.3; 0; 0], 0, "hold", m.states{1}, "free", m.inputs{1});
%! assert (r.x(1), 0.3);
%! assert (max (abs (m.rhs (0, r.x, r.v))) < 1e-9);
%! assert (isempty (r.indifferent));
%!test <nothing is free, and one input that is free>
%! m = gsmbp_hand ("motor_pendulum");
%! hold = {"hold", m.states([1, 3])};
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, hold{:})", "no equilibrium found near the guess");
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, hold{:}, \"free\", m.inputs{1})", "no equilibrium");
%!error <expected the name of a state, found "nobody"; known: >
%! gsmbp_trim (gsmbp_hand ("motor_pendulum"), [0;0;0], 0, "hold", "nobody")
%!test <what does not vanish, and what could help>
%! m = gsmbp_hand ("motor_pendulum");
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, \"hold\", m.states{1})", ...
%!       "acceleration of .* rad/s\\^2; these");
