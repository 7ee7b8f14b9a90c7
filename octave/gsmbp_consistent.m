## -*- texinfo -*-
## @c category Design
## @deftypefn  {} {@var{c} =} gsmbp_consistent (@var{m}, @var{e})
## @deftypefnx {} {@var{c} =} gsmbp_consistent (@var{m}, @var{e}, @var{option}, @var{value}, @
## @dots{})
## The estimates nearest to those of @code{gsmbp_identify} that bodies can have.
##
## Base parameters by least squares may belong to no bodies at all: a negative mass, moments of
## inertia that break the triangle inequality.  Ten numbers of a link are those of a body exactly if
## its pseudo-inertia, the 4 x 4 matrix of the second moments of its mass,
## [Sigma, h; h', m] with Sigma = trace(I)/2 - I about the origin of the link, is positive definite;
## friction, rotors and motor constants have to be above 0.  Looked for are the standard parameters
## x of the links of @var{m} that minimize
## @example
## norm (R*(K*x) - z)^2/2 + g*sum (trace (P0\P) - log (det (P0\P)) - 4)
## @end example
## the first term is half of what chi2 of the estimates @var{e} gains, the second a measure of how
## far each pseudo-inertia P is from that of the model, P0 (its log-det divergence), which keeps P
## positive definite and decides what the motion does not feel.  g goes down in steps of five; for
## each, Newton's method with step control runs until its decrement is below 1e-6 of g.  It stops
## where g times the number of eigenvalues is "gap" (default 0.1; a standard deviation of one
## estimate makes 0.5 of the first term).  Where no body comes near the data a very small gap lets
## links grow without end for ever less misfit.
##
## Options: "gap"; "iterations": at most so many steps of Newton's method (default 500).
##
## A pseudo-inertia of the model that is not positive definite (a point mass) has its small
## eigenvalues raised in P0; a warning names those below 0 (an inertia that no body has).
##
## @var{c} has the fields of @var{e} with the new @code{p} (@code{covariance} and @code{sigma} stay
## those of least squares), and
## @table @code
## @item standard, standard_names
## the standard parameters
## @item links
## a struct array: @code{name}, @code{mass}, @code{centre} (3, axes of the link, from its origin),
## @code{inertia} (3 x 3, about the centre of mass), @code{pseudo} (4 x 4), @code{least}, its
## smallest eigenvalue over its largest one in lengths of the machine
## @item gain
## what chi2 gains over least squares: far below 1, these estimates were consistent already
## @item iterations, gap
## steps of Newton's method; g times the number of eigenvalues at the end
## @end table
##
## @c session octave
## @example
## >> m = gsmbp_build ("pinned");
## >> heavy = gsmbp_set (m, "mb", 2.5, "d", 0.3);
## >> p = gsmbp_plan ("quintic", [0 2 -1], [0 1 2.5]);
## >> r = gsmbp_inverse (heavy, p, 0:0.02:2.5);
## >> data = struct ("t", r.t, "q", r.q, "u", r.u, "ud", r.ud, "tau", r.tau);
## >> e = gsmbp_identify (m, data, "sigma", 0.1);
## >> c = gsmbp_consistent (m, e);
## >> c.gain < 0.01 && c.links.least > 0
## ans = 1
## @end example
##
## Errors: estimates with fixed base parameters, or of another model; no convergence.
## Source: Wensing, Kim and Slotine, IEEE Robotics and Automation Letters 3 (2017) (pseudo-inertia);
## Lee, Wensing and Park, IEEE Transactions on Robotics 36 (2020) (log-det divergence).
## @seealso{gsmbp_identify, gsmbp_adopt, gsmbp_validate}
## @end deftypefn

function c = gsmbp_consistent (m, e, varargin)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_consistent";
  gs.given.check_model (who, m);
  gs.given.check_estimates (who, e);
  o = gs.given.call_options (who, {"gap", 0.1, "positive"; "iterations", 500, "whole"}, varargin);
  s = problem (who, m, e);
  g = max (sumsq (e.R * (s.K * s.x) - e.z) / s.count, o.gap / s.count);
  x = s.x;
  steps = 0;
  do
    [x, steps] = newton (who, s, e, x, g, steps, o.iterations);
    last = g <= o.gap / s.count;
    if (! last)
      g = max (g / 5, o.gap / s.count);
    endif
  until (last)
  c = e;
  c.p = s.K * x;
  n = numel (s.names);
  [c.standard, c.standard_names] = deal (x(1:n), s.names);
  c.gain = sumsq (e.R * c.p - e.z);
  [c.iterations, c.gap] = deal (steps, g * s.count);
  c.links = links_of (s, x);
endfunction

## unknowns x (standard parameters, further columns), K with p = K*x, pseudo-inertias of links with
## their places in x, places of what has to be above 0, a start
function s = problem (who, m, e)
  s = gs.identify.standard_parameters (m);
  names = gs.given.names_and_units (m.json.base_parameters);
  base = strcmp (e.kind, "base");
  if (! isequal (e.names(base), names))
    error (["%s: expected estimates of all %d base parameters of %s, found %d: fix none of " ...
            "them in gsmbp_identify"], who, numel (names), m.name, sum (base));
  endif
  further = find (! base);
  s.x = [s.nominal; e.p(further)];
  s.K = blkdiag (s.K, eye (numel (further)));
  s.links = find (! cellfun (@isempty, regexp (s.names, '_hx$')))' - 1;
  s.place = s.links + (0:9)';
  scalar = setdiff (1:numel (s.names), s.place(:)');
  for k = 1:numel (further)
    if (! strncmp (fliplr (e.names{further(k)}), fliplr ("_offset"), 7))
      scalar(end+1) = numel (s.names) + k;
    endif
  endfor
  s.scalar = scalar;
  s.count = 4 * numel (s.links) + numel (scalar);
  s = with_start (who, m, s);
endfunction

## the inverse of P0 of each link, scales of the scalars
function s = with_start (who, m, s)
  P = arrayfun (@(k) gs.identify.pseudo_inertia (s.x(s.place(:,k))), 1:numel (s.links), ...
                "UniformOutput", false);
  mass = sum (cellfun (@(p) abs (p(4,4)), P)) / numel (P) + realmin;
  way = sqrt (sum (cellfun (@(p) abs (trace (p(1:3,1:3))), P)) / (3 * mass * numel (P))) + 1e-9;
  s.D = diag ([way way way 1]) * sqrt (mass);
  raised = {};
  for k = 1:numel (P)
    [V, l] = eig (s.D \ P{k} / s.D, "vector");
    if (min (l) < 1e-9 * max (l) || max (l) <= 0)
      if (min (l) < -1e-9 * max (abs (l)))
        raised{end+1} = s.names{s.links(k)}(1:end-2);
      endif
      l = max (l, 1e-2 * max (1, max (l)));
      P{k} = s.D * V * diag (l) * V' * s.D;
      s.x(s.place(:,k)) = gs.identify.ten_parameters (P{k});
    endif
    s.inverse{k} = inv ((P{k} + P{k}') / 2);
  endfor
  s.x(s.scalar) = max (s.x(s.scalar), 1e-3 * max (abs (s.x(s.scalar))) + 1e-9);
  s.first = s.x(s.scalar);
  if (! isempty (raised))
    warning ("gsmbp:consistent", ["%s: %s: no body has the inertia of %s in the model: its " ...
                                  "small eigenvalues were raised where the search begins"], who, ...
             m.name, strjoin (raised, ", "));
  endif
endfunction

## minimize for one g; the decrement is the square of a norm: rounding does not make it negative
function [x, steps] = newton (who, s, e, x, g, steps, most)
  A = e.R * s.K;
  do
    if (++steps > most)
      error ("%s: no convergence in %d steps of Newton's method (option iterations)", who, most);
    endif
    [grad, U] = barrier (s, x);
    B = [A; sqrt(g) * U];
    d = B \ [e.z - A * x; -sqrt(g) * (U' \ grad)];
    decrement = sumsq (B * d);
    step = 1;
    change = along (s, e, A, x, d, g);
    rounding = 4 * eps * abs (merit (s, e, A, x, g));
    while (! (change (step) <= rounding - 1e-4 * step * decrement))
      step /= 2;
      if (step < 1e-15)
        error ("%s: no convergence: no step makes it less (decrement %.1e)", who, decrement / g);
      endif
    endwhile
    x += step * d;
  until (decrement <= 1e-6 * g)
endfunction

function f = merit (s, e, A, x, g)
  f = sumsq (A * x - e.z) / 2;
  for k = 1:numel (s.links)
    P = gs.identify.pseudo_inertia (x(s.place(:,k)));
    f += g * (s.inverse{k}(:)' * P(:) - 2 * sum (log (diag (chol (P)))));
  endfor
  y = x(s.scalar);
  f += g * sum (y ./ s.first - log (y));
endfunction

## what a step adds to the merit, a function of its length along D: log (det (P + step*dP)) is
## log (det (P)) and the sum of log (1 + step*l), l the eigenvalues of P^-1*dP
function change = along (s, e, A, x, d, g)
  [r, rd] = deal (A * x - e.z, A * d);
  y = x(s.scalar);
  dy = d(s.scalar);
  linear = sum (dy ./ s.first);
  l = dy ./ y;
  for k = 1:numel (s.links)
    C = chol (gs.identify.pseudo_inertia (x(s.place(:,k))));
    dP = gs.identify.pseudo_inertia (d(s.place(:,k)));
    linear += s.inverse{k}(:)' * dP(:);
    W = C' \ dP / C;
    l = [l; eig((W + W') / 2)];
  endfor
  change = @(step) by_step (step, r' * rd + g * linear, sumsq (rd) / 2, l, g);
endfunction

## Inf where a body is none any more, or nearly so
function f = by_step (step, linear, square, l, g)
  f = Inf;
  left = 1 + step * l;
  if (all (left > 1e-6))
    f = step * linear + step ^ 2 * square - g * sum (log (left));
  endif
endfunction

## gradient of the second term and a square root of its matrix of second derivatives; the
## pseudo-inertia is linear in its ten parameters: of the unit vectors it is E
function [grad, U] = barrier (s, x)
  persistent E = cell2mat (arrayfun (@(j) vec (gs.identify.pseudo_inertia ((1:10 == j)')), 1:10, ...
                                     "UniformOutput", false));
  grad = zeros (numel (x), 1);
  U = zeros (16 * numel (s.links) + numel (s.scalar), numel (x));
  for k = 1:numel (s.links)
    at = s.place(:,k);
    C = chol (gs.identify.pseudo_inertia (x(at)));
    invC = inv (C);
    pull = s.inverse{k} - invC * invC';
    grad(at) = E' * pull(:);
    U(16*(k-1)+(1:16),at) = kron (invC', invC') * E;   # columns (invC' * E * invC)(:)
  endfor
  y = x(s.scalar);
  grad(s.scalar) = 1 ./ s.first - 1 ./ y;
  rest = 16 * numel (s.links) + (1:numel (s.scalar));
  U(rest,s.scalar) = diag (1 ./ y);
  loose = setdiff (1:numel (x), [s.place(:)', s.scalar]);   # offsets: a little, to stay regular
  U = [U; zeros(numel (loose), numel (x))];
  U(end-numel(loose)+1:end,loose) = 1e-6 * eye (numel (loose));
  [~, U] = qr (U, 0);
endfunction

function list = links_of (s, x)
  for k = 1:numel (s.links)
    P = gs.identify.pseudo_inertia (x(s.place(:,k)));
    one.name = s.names{s.links(k)}(1:end-2);
    one.mass = P(4,4);
    one.centre = P(1:3,4) / one.mass;
    moments = P(1:3,1:3) - one.mass * one.centre * one.centre';
    one.inertia = trace (moments) * eye (3) - moments;
    one.pseudo = P;
    l = eig (s.D \ P / s.D);
    one.least = min (l) / max (l);
    list(k) = one;
  endfor
endfunction

%!error <argument e: expected a result of gsmbp_identify>
%! addpath (fullfile (fileparts (which ("gsmbp_build")), "hand"));
%! gsmbp_consistent (gsmbp_hand ("motor_pendulum"), 3)
