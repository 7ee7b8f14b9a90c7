## list = gs.collocation.find_singular (m, p, s)
## Where inputs of a solution S are not determined by the minimum principle itself: between their
## limits on more than two intervals in turn, where the second derivative of the Hamiltonian by them
## is nothing (the condition of Legendre and Clebsch holds as an equation). A struct for each such
## arc: input (number), name, from, until [s], ringing: how far the input is from a cubic through
## the points of three intervals, weight (0), held: a state or an output is at a limit there, so
## that the input follows from that.
## Source: Betts (2010), section 4.14; Bryson and Ho, Applied Optimal Control, 1975, chapter 8.

function list = find_singular (m, p, s)
  list = struct ("input", {}, "name", {}, "from", {}, "until", {}, "ringing", {}, "weight", {}, ...
                 "held", {});
  if (isempty (s) || ! s.solved)
    return;
  endif
  c = s.c;
  [inner, span, held] = between (p, s, c.nz - c.d.nv + (1:c.d.nv));
  flat = undetermined (s, inner, span);
  least = 2 * numel (c.mesh.rule.own) + 2;   # points in turn
  for j = 1:c.d.nv
    kind = flat(j,:) .* (1 + held);
    first = find (diff ([0, kind]) != 0);
    last = [first(2:end) - 1, numel(kind)];
    for k = find (kind(first) > 0 & last - first + 1 >= least)
      q = c.stages([first(k), last(k)]);
      list(end+1) = struct ("input", j, "name", m.inputs{j}, "from", s.times(q(1)), "until", ...
                            s.times(q(2)), "ringing", ringing (s, j, q), "weight", 0, "held", ...
                            held(first(k)));
    endfor
  endfor
endfunction

## For each input at each stage: is it between its limits (never where these are equal)? The width
## of each input; whether a state or an output is at a limit.
function [inner, span, held] = between (p, s, v)
  c = s.c;
  q = c.stages;
  low = p.low(v);
  high = p.high(v);
  span = high - low;
  some = ! isfinite (span);
  moved = gs.collocation.input_width (s.v(:,q));
  span(some) = moved(some);
  inner = ! at_limits (s.v(:,q), low, high, 1e-3 * span) & span > 0;
  held = any (at_limits (s.x(:,q), p.low(1:c.d.nx), p.high(1:c.d.nx), ...
                         1e-6 * width (s.x)), 1);
  if (! isempty (p.outputs))
    y = s.F(c.bounded,q);
    held |= any (at_limits (y, [p.outputs.low]', [p.outputs.high]', 1e-6 * width (y)), 1);
  endif
endfunction

function yes = at_limits (x, low, high, near)
  yes = x < low + near | x > high - near;
endfunction

function w = width (x)
  w = max (x, [], 2) - min (x, [], 2);
endfunction

## the inputs that the Hamiltonian does not bend by, at each stage
function flat = undetermined (s, inner, span)
  c = s.c;
  f = s.plain;
  at = f ("places");
  J = sparse (at{1}(:,1), at{1}(:,2), f ("jac", s.z), c.m, c.n);
  H = sparse (at{2}(:,1), at{2}(:,2), f ("hess", s.z, 1, s.multipliers), c.n, c.n);
  weight = (s.T * c.weights)(c.stages);
  most = 1e-6 * (1 + abs (s.J)) / sum (s.T);
  flat = false (size (inner));
  others = c.d.nx + (1:c.d.nu + c.d.nlam);
  for k = find (any (inner, 1) & weight > 0)
    l = c.at((c.d.nx+1:c.nz)', c.stages(k));
    R = full (J(c.residual(:,k),l));
    n = numel (others);
    i = find (inner(:,k));
    D = [-pinv(R(:,1:n)) * R(:,n+i); eye(c.d.nv)(:,i)] * diag (span(i));   # loops may repeat
    W = full (H(l,l));
    W = D' * (W + tril (W, -1)') * D / weight(k);
    [V, e] = eig ((W + W') / 2, "vector");
    flat(i,k) = any (abs (V(:,abs (e) < most)) > 0.1, 2);
  endfor
endfunction

## the largest distance from a cubic through the points of three intervals
function most = ringing (s, j, q)
  c = s.c;
  most = 0;
  k = find (c.left >= q(1) & c.stage(end,:) <= q(2));
  for i = 2:numel (k) - 1
    points = unique (c.stage(:,k(i-1:i+1))(:));
    points = points(ismember (points, c.stages));
    t = s.times(points)(:);
    t = (t - mean (t)) / (t(end) - t(1));
    A = t .^ (0:3);
    most = max (most, max (abs (s.v(j,points)' - A * (A \ s.v(j,points)'))));
  endfor
endfunction
