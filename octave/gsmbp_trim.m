## -*- texinfo -*-
## @deftypefn  {} {@var{r} =} gsmbp_trim (@var{m}, @var{x}, @var{v})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "hold", @var{names}, "free", @var{inputs})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "time", @var{t}, "tolerance", @var{tol})
## @deftypefnx {} {@var{r} =} gsmbp_trim (@dots{}, "margins", @var{word})
## An equilibrium of a scene: a state at rest, with loops closed, in which
## nothing is accelerated.
##
## From the guess @var{x} (@var{nx} states, or the @var{nq} coordinates: the
## states of the devices then start as the scene says) and the inputs @var{v}
## (@var{nv}, zeros by default) of the model @var{m} all coordinates and states
## of devices are adjusted by Newton's method with the exact Jacobians; speeds
## are zero.  States named in "hold" keep their value, inputs named in "free"
## are adjusted as well.  What a sampled device holds, and the modes of events,
## are inputs here.
##
## States count by their usual sizes (@code{m.nominal}), and the iteration goes
## on as long as the equations gain digits.  An equilibrium is one where every
## rate is below @var{tol} (default 1e-9) times the usual size of its state in a
## second, every constraint below @var{tol}, or where rounding of the terms
## hides the rest.
##
## @var{r} has the fields @code{x}, @code{v}, @code{ud} (accelerations that are
## left, zero to rounding), @code{lambda} (multipliers), @code{unique} (which
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
## Errors: no equilibrium is found (the equations that do not vanish are
## named); a constraint that moves with time; a margin of a device below 0; an
## unknown name in "hold" or "free".
## Source: own: Newton's method with the exact Jacobians, Levenberg's and a
## transient where it fails.
## @seealso{gsmbp_linear, gsmbp_assemble}
## @end deftypefn

function r = gsmbp_trim (m, x, v, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  gsmbp__model ("gsmbp_trim", m);
  if (nargin < 3)
    v = [];
  endif
  table = {"hold", {}, "names"
           "free", {}, "names"
           "time", 0, "number"
           "tolerance", 1e-9, "tolerance"
           "margins", "check", {"check", "ignore"}};
  o = gsmbp__options ("gsmbp_trim", table, varargin);
  p = problem (m, x, v, o);
  check_rest (p, p.z);
  [z, way] = solve (p);
  check_rest (p, z);
  if (! (worst (p, z) <= 1))
    refuse (p, z);
  endif
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

function [best, word] = solve (p)
  best = p.z;
  for way = {"newton", "levenberg", "transient"; @newton, @levenberg, @transient}
    z = way{2} (p, p.z);
    if (worst (p, z) < worst (p, best))
      best = z;
    endif
    word = way{1};
    if (worst (p, best) <= 1)
      return;
    endif
  endfor
endfunction

## where the equilibrium does not stand alone: the one with as many unknowns as can be left as
## in the guess, coordinates first
function [p, z] = nearest (p, z, free)
  keep = [];
  for k = 1:rows (free)
    if (rank (free([keep, k],:), 1e-6) > numel (keep))
      keep(end+1) = k;
    endif
  endfor
  if (isempty (keep))
    return;
  endif
  q = p;
  q.fixed = keep;
  y = newton (q, merge (ismember ((1:numel (z))', keep), p.z, z));
  if (worst (p, y) <= 1)
    [p, z] = deal (q, y);
  endif
endfunction

## the guess, what is adjusted (z: numbers OWN of the states, INPUTS) and the sizes of it
function p = problem (m, x, v, o)
  p = struct ("who", "gsmbp_trim", "m", m, "t", o.time, "tolerance", o.tolerance);
  d = m.sizes;
  if (! any (strcmp (m.subroutines, "jac")))
    error ("%s: %s was emitted without the subroutine JAC", p.who, m.name);
  endif
  x = gsmbp__guess (p.who, m, "x", x, m.initial(d.nq + 1:d.nx));
  x(d.nq + (1:d.nu)) = 0;
  if (isempty (v))
    v = zeros (d.nv, 1);
  endif
  named = sprintf (" (the inputs %s)", strjoin (m.inputs', ", "));
  v = gsmbp__vector (p.who, "v", v, d.nv, named, m.inputs);
  held = places (p.who, o.hold, m.states, "hold", "a state");
  p.inputs = places (p.who, o.free, m.inputs, "free", "an input")(:)';
  p.own = setdiff ([1:d.nq, d.nq + d.nu + 1:d.nx], held);
  p.held = held;
  if (d.nlam > 0 || d.nq > d.nu)
    x = closed (m, x, held, o.time);
  endif
  p.x = x;
  p.v = v;
  p.fixed = [];   # unknowns that stay where they are
  p.z = [x(p.own); v(p.inputs)];
  p.size = [m.nominal(p.own); ones(numel (p.inputs), 1)];
  p.usual = [m.nominal(d.nq + 1:d.nx); ones(d.nlam + rows (m.orientation), 1)];
  p.size = sizes (p);
endfunction

## a free input counts by what moves the rates as much as the usual sizes of the states do
function s = sizes (p)
  s = p.size;
  n = numel (p.own);
  [~, J] = equations (p, p.z);
  if (! all (isfinite (J(:))))
    return;
  endif
  row = abs (J(:,1:n)) * s(1:n);
  for k = n + (1:numel (p.inputs))
    reach = max (row, p.usual) ./ abs (J(:,k));
    least = min (reach(isfinite (reach) & reach > 0));
    if (! isempty (least))
      s(k) = max (least, abs (p.z(k)));
    endif
  endfor
endfunction

## accelerations, rates of states of devices, constraints, norms of Euler parameters; and their
## derivatives
function [f, J] = equations (p, z, t = p.t)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = state (p, z);
  [xd, ~] = m.rhs (t, x, v);
  f = xd(d.nq + 1:end);
  if (d.nlam > 0)
    f = [f; m.con(t, x(1:d.nq), zeros (d.nu, 1))];
  endif
  [g, N] = norms (m, x);
  f = [f; g];
  if (nargout < 2)
    return;
  endif
  [A, B, ~, ~, ~] = m.jac (t, x, v);
  J = [A(d.nq + 1:end, p.own), B(d.nq + 1:end, p.inputs)];
  if (d.nlam > 0)
    P = [m.tan(t, x), zeros(d.nlam, d.nx - d.nq)];
    J = [J; P(:,p.own), zeros(d.nlam, numel (p.inputs))];
  endif
  J = [J; N(:,p.own), zeros(rows (N), numel (p.inputs))];
endfunction

function [x, v] = state (p, z)
  [x, v] = deal (p.x, p.v);
  n = numel (p.own);
  x(p.own) = z(1:n);
  v(p.inputs) = z(n + 1:end);
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

## the largest of the equations beside what they may be: at most 1 in an equilibrium
function [w, beside] = worst (p, z)
  [f, J] = equations (p, z);
  rounding = 1e3 * eps * (abs (J) * max (abs (z), p.size));
  beside = abs (f) ./ max (p.tolerance * p.usual, rounding);
  beside(! isfinite (beside)) = Inf;
  w = max ([beside; 0]);
endfunction

## Newton's correction in units of the usual sizes, by an inverse that leaves out what moves nothing
function [correct, good] = corrector (p, z)
  [f, J] = equations (p, z);
  row = abs (J) * p.size;
  row(! (row > 0)) = 1;
  K = J .* p.size' ./ row;
  K(:,p.fixed) = 0;
  good = all (isfinite (K(:))) && all (isfinite (f));
  if (! good)
    correct = @(f) NaN (numel (z), 1);
    return;
  endif
  inverse = pinv (K, 1e-12 * max ([norm(K), realmin]));
  inverse(p.fixed,:) = 0;
  correct = @(f) -inverse * (f ./ row);
endfunction

## Newton's method; a step counts as good if the next correction, by the same inverse, is smaller
## (whatever the units of the equations and however stiff they are); on to rounding
function z = newton (p, z)
  damping = 1;
  for k = 1:200
    [correct, good] = corrector (p, z);
    step = correct (equations (p, z));
    if (! good || norm (step) == 0)
      return;
    endif
    [next, damping] = damped (p, z, step, correct, damping);
    if (isempty (next))
      return;
    endif
    if (norm (step, Inf) < 1e-7 && norm (correct (equations (p, next))) >= norm (step) / 2)
      return;   # rounding: nothing is gained any more
    endif
    z = next;
  endfor
endfunction

function [next, damping] = damped (p, z, step, correct, damping)
  damping = min ([1, 4 * damping, bound(p, step)]);
  while (damping > 1e-9)
    next = z + damping * step .* p.size;
    after = norm (correct (equations (p, next)));
    if (after <= (1 - damping / 4) * norm (step) || (damping == 1 && norm (step, Inf) < 1e-7))
      return;
    endif
    damping /= 2;
  endwhile
  next = [];
endfunction

## the part of a step that turns nothing by more than half a radian, and moves nothing by more
## than ten times its usual size
function part = bound (p, step)
  n = sum (p.own <= p.m.sizes.nq);
  largest = 10 * ones (numel (step), 1);
  largest(strcmp (p.m.units.coordinates(p.own(1:n)), "rad")) = 0.5;
  largest(ismember (p.own, p.m.orientation(:))) = 0.25;
  part = min ([1; largest ./ max(abs (step), realmin)]);
endfunction

## least squares in scaled equations, where Newton's method stands still: regularized, so that a
## derivative that vanishes does no harm
function z = levenberg (p, z)
  mu = 1e-3;
  for k = 1:200
    [f, J] = equations (p, z);
    row = max (abs (J) * p.size, p.usual);
    [K, g] = deal (J .* p.size' ./ row, f ./ row);
    if (! all (isfinite ([K(:); g])))
      return;
    endif
    step = -[K; sqrt(mu) * eye(columns (K))] \ [g; zeros(columns (K), 1)];
    next = z + bound (p, step) * step .* p.size;
    if (norm (equations (p, next) ./ row) < norm (g))
      z = next;
      mu /= 5;
    else
      mu *= 4;
    endif
    if (mu > 1e12 || norm (step, Inf) < 1e-8)
      break;
    endif
  endfor
  z = newton (p, z);
endfunction

## the motion itself by implicit Euler steps that grow as it comes to rest: it ends in a stable
## equilibrium
function z = transient (p, z)
  [m, d] = deal (p.m, p.m.sizes);
  moving = setdiff (1:d.nx, [p.held, d.nq + p.held(p.held <= d.nq & d.nq == d.nu)]);
  size = m.nominal(moving);
  [x, v] = state (p, z);
  for k = 1:300
    [xd, ~] = m.rhs (p.t, x, v);
    [A, ~, ~, ~, ~] = m.jac (p.t, x, v);
    K = A(moving,moving) .* size' ./ size;
    f = xd(moving) ./ size;
    if (! all (isfinite ([K(:); f])) || norm (f) == 0)
      break;
    endif
    if (k == 1)
      h = least = 0.3 / norm (f);
    else
      h = max (least, h * min (2, max (0.5, before / norm (f))));
    endif
    before = norm (f);
    step = (eye (numel (f)) / h - K) \ f;
    x(moving) += size .* step / max (1, 2 * norm (step(moving <= d.nq), Inf));
    if (d.nlam > 0 || d.nq > d.nu)
      [x, ~, ~] = m.prj (p.t, x);
    endif
  endfor
  z = newton (p, [x(p.own); v(p.inputs)]);
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
  x(m.sizes.nq + (1:m.sizes.nu)) = 0;
endfunction

## with all speeds zero no constraint may move, nor begin to
function check_rest (p, z)
  d = p.m.sizes;
  if (d.nlam == 0)
    return;
  endif
  x = state (p, z);
  [~, phit, ~, gam, ~] = p.m.con (p.t, x(1:d.nq), zeros (d.nu, 1));
  for found = {phit, -gam; "moves at %g", "starts with an acceleration of %g"; "/s", "/s^2"}
    k = find (! (abs (found{1}) <= p.tolerance), 1);
    if (! isempty (k))
      rate = sprintf ([found{2} "%s%s"], found{1}(k), constraint_unit (p.m, k), found{3});
      error (["%s: %s: no state at rest at t = %g s: with all speeds zero the constraint %s " ...
              "%s, " ...
              "it is driven with time; take a time at which it rests (option \"time\")"],
             p.who, p.m.name, p.t, p.m.multipliers{k}, rate);
    endif
  endfor
endfunction

## no device may be where its laws do not hold
function check_margins (p, r)
  list = gsmbp__margins (p.m, p.t, r.x', r.v');
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
  [f, J] = equations (p, z);
  limit = max (p.tolerance * p.usual, 1e3 * eps * (abs (J) * max (abs (z), p.size)));
  for later = [0.618, 3.7, 19.1]
    k = find (! (abs (equations (p, z, p.t + later)) <= 10 * limit), 1);
    if (! isempty (k))
      warning ("gsmbp:trim", "%s: %s: an equilibrium at t = %g s alone: %s changes with time",
               p.who, p.m.name, p.t, names (p){k});
      return;
    endif
  endfor
endfunction

## names of the equations, and their units
function [text, unit] = names (p)
  [m, d] = deal (p.m, p.m.sizes);
  text = [strcat({"acceleration of "}, m.speeds(:)); ...
          strcat({"rate of "}, m.states(d.nq + d.nu + 1:d.nx)(:))];
  unit = regexprep (strcat (m.units.states(d.nq + 1:d.nx)(:), "/s"), "/s/s$", "/s^2");
  for k = 1:d.nlam
    text{end+1,1} = ["constraint " m.multipliers{k}];
    unit{end+1,1} = strtrim (constraint_unit (m, k));
  endfor
  for k = 1:rows (m.orientation)
    text{end+1,1} = ["norm of " m.states{m.orientation(k,1)} " .. " m.states{m.orientation(k,4)}];
    unit{end+1,1} = "1";
  endfor
endfunction

## of a constraint: m where its multiplier is a force; nothing where that is not known
function unit = constraint_unit (m, k)
  units = {" m", " rad", ""};
  unit = units([strcmp(m.units.multipliers{k}, {"N", "N*m"}), true]){1};
endfunction

function refuse (p, z)
  [w, beside] = worst (p, z);
  f = equations (p, z);
  [text, unit] = names (p);
  [~, order] = sort (beside, "descend");
  order = order(beside(order) > 1)(1:min (end, 4));
  left = cell (1, numel (order));
  for k = 1:numel (order)
    left{k} = sprintf ("%s = %g %s", text{order(k)}, f(order(k)), unit{order(k)});
  endfor
  help = helpers (p, z);
  advice = "try another guess, or let inputs be free";
  if (! isempty (help))
    advice = ["these inputs act on it: " strjoin(help, ", ") " (option \"free\")"];
  endif
  error ("%s: %s: no equilibrium found near the guess; what does not vanish: %s; %s", p.who,
         p.m.name, strjoin (left, ", "), advice);
endfunction

## inputs that act on what the states cannot take away
function list = helpers (p, z)
  list = {};
  [x, v] = state (p, z);
  d = p.m.sizes;
  [f, J] = equations (p, z);
  row = max (abs (J) * p.size, p.usual);
  K = J .* p.size' ./ row;
  g = f ./ row;
  [~, B, ~, ~, ~] = p.m.jac (p.t, x, v);
  B = [B(d.nq + 1:end,:); zeros(rows (J) - d.nx + d.nq, d.nv)] ./ row;
  if (! all (isfinite ([K(:); g; B(:)])))
    return;
  endif
  g -= K * (pinv (K, 1e-10 * max (norm (K), realmin)) * g);
  for k = setdiff (1:d.nv, p.inputs)
    if (norm (g) > 0 && abs (g' * B(:,k)) > 1e-6 * norm (g) * norm (B(:,k)))
      list{end+1} = p.m.inputs{k};
    endif
  endfor
endfunction

function r = result (p, z, way)
  [m, d] = deal (p.m, p.m.sizes);
  [x, v] = state (p, z);
  xd = m.rhs (p.t, x, v);
  f = equations (p, z);
  r = struct ("x", x, "v", v, "ud", xd(d.nq + (1:d.nu)), "lambda", zeros (0, 1), ...
              "phi", zeros (0, 1), "residual", max ([abs(f) ./ p.usual; 0]), "way", way);
  if (d.nlam > 0)
    [~, r.lambda] = m.acc (p.t, x, v);
    r.phi = m.con (p.t, x(1:d.nq), zeros (d.nu, 1));
  endif
endfunction

## what can be moved without effect on the equations: an orthonormal basis, in units of the
## usual sizes
function free = spaces (p, z)
  [~, J] = equations (p, z);
  row = abs (J) * p.size;
  row(! (row > 0)) = 1;
  [~, S, V] = svd (J .* p.size' ./ row);
  s = diag (S)(1:min (size (S)));
  free = V(:,sum (s > 1e-12 * max ([s; realmin])) + 1:end);
endfunction

function names = unknowns (p)
  names = [p.m.states(p.own)(:); p.m.inputs(p.inputs)(:)];
endfunction

function k = places (who, names, all_names, option, what)
  names = cellstr (names)(! cellfun (@isempty, cellstr (names)));
  k = gsmbp__which (names, all_names);
  if (! all (k))
    error ("%s: option \"%s\": expected the name of %s, found %s", who, option, what,
           gsmbp__unknown (names{find (! k, 1)}, all_names));
  endif
endfunction

%!test
%! addpath (fullfile (fileparts (fileparts (which ("gsmbp_build"))), "tests", "octave"));
%! m = gsmbp_hand ("motor_pendulum");
%! r = gsmbp_trim (m, [0.3; 0; 0], 0, "hold", m.states{1}, "free", m.inputs{1});
%! assert (r.x(1), 0.3);
%! assert (max (abs (m.rhs (0, r.x, r.v))) < 1e-9);
%! assert (isempty (r.indifferent));
%!error <expected the name of a state, found "nobody"; known: >
%! gsmbp_trim (gsmbp_hand ("motor_pendulum"), [0;0;0], 0, "hold", "nobody")
%!test <what does not vanish, and what could help>
%! m = gsmbp_hand ("motor_pendulum");
%! fail ("gsmbp_trim (m, [0.3; 0; 0], 0, \"hold\", m.states{1})", ...
%!       "acceleration of .* rad/s\\^2; these");
