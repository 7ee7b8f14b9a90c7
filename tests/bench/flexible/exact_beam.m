## R = exact_beam (BEAM, MOTION, T, STEPS, P): a plane beam of Reissner's theory (Simo, Vu-Quoc,
## J. Applied Mechanics 53, 1986): large turns, stretch, shear, inertia of sections. Place and turn
## of the sections are polynomials of degree P over the whole length, in axes that turn about z as
## given, so that the mass matrix is constant; the energy of the strains is a sum over P Gauss
## points. In time Radau's formula of three stages (IIA, order 5), which damps what is too fast for
## its steps, STEPS of them between the times T (equal distances).
##
## BEAM: length, mass (by length), EI, EA, GA (with the factor of shear), rho_I (by length), tip
## (mass at the end). MOTION: held, numbers among 1..3*(P+1) of what moves as prescribed: x, y, turn
## at the nodes from root to tip (x1 .. xn y1 .. yn a1 .. an); moved (t), a row for each of them:
## place, rate, acceleration; turning (t): angular velocity and acceleration of the axes; u0, v0 of
## all (functions of the nodes' places s).
## R.u: columns for T; R.nodes: s.

function r = exact_beam (beam, motion, t, steps, p)
  m = discrete (beam, p);
  n = 3 * (p + 1);
  m.motion = motion;
  m.free = setdiff (1:n, motion.held);
  h = (t(2) - t(1)) / steps;
  [u, v, a] = deal (motion.u0 (m.nodes), motion.v0 (m.nodes), zeros (n, 3));
  r = struct ("u", u, "nodes", m.nodes);
  for k = 2:numel (t)
    for j = 1:steps
      [u, v, a] = radau_ (m, t(k-1) + (j - 1) * h, h, u, v, a);
    end
    r.u(:,k) = u;
  end
end

## Lobatto's nodes; values N and derivatives D of the polynomials at Gauss points, times weights
function m = discrete (beam, p)
  m.beam = beam;
  m.nodes = beam.length * (1 - cos (pi * (0:p)' / p)) / 2;
  [m.N, m.D, m.w] = at_points (m.nodes, beam.length, p);
  [N, ~, w] = at_points (m.nodes, beam.length, p + 1);
  M = N' * (w .* N);
  tip = zeros (p + 1);
  tip(end,end) = beam.tip;
  m.M = blkdiag (beam.mass * M + tip, beam.mass * M + tip, beam.rho_I * M);
end
function [N, D, w] = at_points (nodes, L, n)
  b = (1:n-1) ./ sqrt (4 * (1:n-1) .^ 2 - 1);
  [V, x] = eig (diag (b, 1) + diag (b, -1));
  x = diag (x);
  w = L * V(1,:)' .^ 2;
  ## Legendre's polynomials and their derivatives at nodes and points
  k = numel (nodes);
  [A, ~] = legendre_ (2 * nodes / L - 1, k);
  [B, C] = legendre_ (x, k);
  [N, D] = deal (B / A, C / A * 2 / L);
end
function [P, D] = legendre_ (x, n)
  P = [ones(size (x)), x];
  D = [zeros(size (x)), ones(size (x))];
  for k = 2:n - 1
    P(:,k+1) = ((2*k - 1) * x .* P(:,k) - (k - 1) * P(:,k-1)) / k;
    D(:,k+1) = D(:,k-1) + (2*k - 1) * P(:,k);
  end
end

## forces of the strains and their derivatives
function [f, K] = strained (m, u)
  n = numel (m.nodes);
  [x, y, a] = deal (m.D * u(1:n), m.D * u(n+1:2*n), m.N * u(2*n+1:end));
  [c, s, b] = deal (cos (a), sin (a), m.beam);
  [e, g] = deal (c .* x + s .* y, c .* y - s .* x);
  [T, Q] = deal (b.EA * (e - 1), b.GA * g);
  D = m.D';
  wD = m.w .* m.D;
  wN = m.w .* m.N;
  f = [wD' * (T .* c - Q .* s); wD' * (T .* s + Q .* c)
       wN' * (T .* g - Q .* e) + D * (m.w .* (b.EI * (m.D * u(2*n+1:end))))];
  if (nargout < 2)
    return;
  end
  xx = D * ((b.EA * c .^ 2 + b.GA * s .^ 2) .* wD);
  xy = D * (((b.EA - b.GA) * s .* c) .* wD);
  yy = D * ((b.EA * s .^ 2 + b.GA * c .^ 2) .* wD);
  xa = D * ((b.EA * g .* c - T .* s + b.GA * e .* s - Q .* c) .* wN);
  ya = D * ((b.EA * g .* s + T .* c - b.GA * e .* c - Q .* s) .* wN);
  aa = m.N' * ((b.EA * g .^ 2 - T .* e + b.GA * e .^ 2 - Q .* g) .* wN) + b.EI * D * wD;
  K = [xx, xy, xa; xy', yy, ya; xa', ya', aa];
end

## one step; a: accelerations at the stages, of the last step as a guess
function [u, v, a] = radau_ (m, t, h, u, v, a)
  s = sqrt (6);
  A = [(88-7*s)/360, (296-169*s)/1800, (3*s-2)/225
       (296+169*s)/1800, (88+7*s)/360, -(3*s+2)/225; (16-s)/36, (16+s)/36, 1/9];
  at = t + h * sum (A, 2)';
  [n, f] = deal (numel (u), numel (m.free));
  held = reshape (cell2mat (arrayfun (m.motion.moved, at, "UniformOutput", false)), [], 3, 3);
  a(m.motion.held,:) = held(:,3,:);
  for pass = 1:12
    V = v + h * a * A';
    U = u + h * v * sum (A, 2)' + h ^ 2 * a * (A ^ 2)';
    U(m.motion.held,:) = held(:,1,:);
    V(m.motion.held,:) = held(:,2,:);
    J = kron (eye (3), m.M(m.free,m.free));
    off = zeros (f, 3);
    for i = 1:3
      [own, by_v, by_u] = of_axes (m, m.motion.turning (at(i)));
      [force, K] = strained (m, U(:,i));
      off(:,i) = (m.M * a(:,i) + force + own + by_v * V(:,i) + by_u * U(:,i))(m.free);
      J((i-1)*f + (1:f),:) += kron (h * A(i,:), by_v(m.free,m.free)) ...
                              + kron (h ^ 2 * (A ^ 2)(i,:), (K + by_u)(m.free,m.free));
    end
    step = reshape (J \ off(:), f, 3);
    a(m.free,:) -= step;
    if (max (abs (step(:))) * h ^ 2 < 1e-8 * m.beam.length)
      [u, v] = deal (U(:,3), V(:,3));
      u(m.free) -= h ^ 2 * step * (A ^ 2)(3,:)';
      v(m.free) -= h * step * A(3,:)';
      return;
    end
  end
  error ("exact_beam: Newton's method does not converge at t = %g", t);
end

## what turning axes add to the forces: own + by_v v + by_u u
function [own, by_v, by_u] = of_axes (m, turning)
  n = numel (m.nodes);
  [w, wd] = deal (turning(1), turning(2));
  turn = kron ([0, -1, 0; 1, 0, 0; 0, 0, 0], eye (n));
  by_v = 2 * w * turn * m.M;
  by_u = wd * turn * m.M - w ^ 2 * kron (diag ([1, 1, 0]), eye (n)) * m.M;
  own = wd * m.M * [zeros(2*n, 1); ones(n, 1)];
end
