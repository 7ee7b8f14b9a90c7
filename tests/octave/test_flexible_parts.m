## What is emitted of scenes with flexible links, each part against another way: trees by modal data
## and by tapered beams, a loop on an elastic joint with a massless link and a rod that starts
## sagged.

function test_flexible_parts ()
  for name = {"flexible_mounted", "flexible_tree", "flexible_data"}
    m = gsmbp_fixture (name{1});
    x = somewhere (m);
    motion_of_equations (name{1}, m, x);
    derivatives (name{1}, m, x);
    power (name{1}, m, x);
    places (name{1}, m, x);
  end
  m = gsmbp_fixture ("flexible_mounted");
  starts_at_rest (m);
  mount (m, somewhere (m));
  batches (m);
  wall ();
end

## a state on the constraints, bent by some mm
function x = somewhere (m)
  d = m.sizes;
  x = m.initial;
  x(1:d.nq) += 0.3 * sin (1:d.nq)' .* (abs (x(1:d.nq)) > 0.1);
  x(1:d.nq) += 0.004 * cos (3 * (1:d.nq))';
  x(d.nq+1:end) = cos (2 * (1:d.nu))' .* min (1, 30 * abs (x(1:d.nq)) + 0.1);
  if (d.nlam > 0)
    x = m.prj (0, x);
  end
end

## M u' + b = H' lambda, H u' = gamma less Baumgarte's terms, and the rates of the coordinates
function motion_of_equations (name, m, x)
  d = m.sizes;
  [q, u] = deal (x(1:d.nq), x(d.nq+1:end));
  [xd, info] = m.rhs (0, x);
  ud = xd(d.nq+1:end);
  b = m.mas (0, q) * ud + m.bia (0, q, u);
  gsmbp_check ([name ": INV is M u' + BIA"], (m.inv (0, q, u, ud) - b) / max (abs (b) + 1), 1e-11);
  scale = max (abs (m.bia (0, q, u)));
  if (d.nlam > 0)
    [~, phit, H, gam] = m.con (0, q, u);
    [~, lam] = m.acc (0, x);
    b -= H' * lam;
    gsmbp_check ([name ": the loop's accelerations"], (H * ud - gam) / max (abs (gam)), 1e-7);
  end
  gsmbp_check ([name ": equations of motion, of the largest effort"], b / scale, 1e-10);
  gsmbp_check ([name ": rates of the coordinates"], ...
               isequal ([xd(1:d.nq); info], [m.kin(0, q, u); 0]));
end

## differences of sixth order with steps of h
function D = differences (f, x, h)
  for k = 1:numel (x)
    e = h * ((1:numel (x))' == k);
    at = @(j) f (x + j * e);
    D(:,k) = (45 * (at (1) - at (-1)) - 9 * (at (2) - at (-2)) + at (3) - at (-3)) / (60 * h);
  end
end
function derivatives (name, m, x)
  d = m.sizes;
  [A, ~, C] = m.jac (0, x);
  D = differences (@(x) m.rhs (0, x), x, 2e-4);
  gsmbp_check ([name ": JAC, of the largest entry of each row"], ...
               (A - D) ./ max (max (abs (D), [], 2), 1), 1e-7);
  [q, u] = deal (x(1:d.nq), x(d.nq+1:end));
  [M, B, K] = m.lin (0, q, u, u);
  D = differences (@(q) m.inv (0, q, u, u), q, 2e-4);
  gsmbp_check ([name ": LIN by coordinates, of the largest entry"], ...
               (K - D) / max (abs (D(:))), 1e-9);
  D = differences (@(v) m.inv (0, q, v, u), u, 1e-2);
  gsmbp_check ([name ": LIN by speeds, of the largest entry"], (B - D) / max (abs (D(:))), 1e-10);
  if (d.nlam > 0)
    D = differences (@(q) m.con (0, q, u), q, 2e-4);
    [~, phit, H] = m.con (0, q, u);
    gsmbp_check ([name ": H is the derivative of phi"], H - D, 1e-10);
  end
  if (d.ny > 0)
    D = differences (@(x) m.out (0, x), x, 2e-4);
    gsmbp_check ([name ": outputs by states, of the largest of each row"], ...
                 (C - D) ./ max (max (abs (D), [], 2), 1), 1e-7);
  end
end

## the energy grows by the powers in and less those lost
function power (name, m, x)
  [xd, ~] = m.rhs (0, x);
  e = @(h) sum (m.ene (0, x + h * xd)(1:2));
  h = 1e-5;
  rate = (8 * (e (h) - e (-h)) - e (2 * h) + e (-2 * h)) / (12 * h);
  p = m.ene (0, x);
  gsmbp_check ([name ": rate of the energy is the power in less the power lost"], ...
               (rate - p(4) + p(5)) / max (1, sum (abs (p(4:5)))), 1e-7);
end

## the Jacobians of points are the derivatives of their places, their rates those of J u
function places (name, m, x)
  if (! any (strcmp (m.subroutines, "pnt")))
    return;
  end
  d = m.sizes;
  [q, u] = deal (x(1:d.nq), x(d.nq+1:end));
  D = differences (@(q) m.pnt (0, q)(:), q, 2e-4);
  [J, rate] = m.jpt (0, q, u);
  J = reshape (J, 6, d.nu, []);
  gsmbp_check ([name ": Jacobians of the points"], ...
               reshape (permute (J(1:3,:,:), [1, 3, 2]), [], d.nu) - D, 1e-9);
  velocities = @(h) velocity (m, q + h * u, u);
  D = differences (velocities, 0, 2e-4);
  gsmbp_check ([name ": (dJ/dt) u of the points"], (rate(:) - D) / max (abs (D)), 1e-9);
end
function v = velocity (m, q, u)
  J = reshape (m.jpt (0, q, u), 6, m.sizes.nu, []);
  for k = 1:size (J, 3)
    v(:,k) = J(:,:,k) * u;
  end
  v = v(:);
end

## the sagged rod starts with its loop closed
function starts_at_rest (m)
  d = m.sizes;
  q = m.initial(1:d.nq);
  phi = m.con (0, q);
  gsmbp_check ("flexible_mounted: it starts closed and bent", ...
               max (abs (phi)) < 1e-14 && all (abs (q(11:13)) > 1e-6));
end

## What the elastic joint exerts, found from the motion of all that it carries, is what its springs
## and dampers say.
function mount (m, x)
  p = m.par;
  d = m.sizes;
  y = m.out (0, x);
  [q, u] = deal (x(1:6), x(d.nq+(1:6)));
  force = -p.k * [1; 2; 3] .* q(1:3) - [5; 6; 7] .* u(1:3);
  turn = -150 * q(4:6) - 2 * u(4:6);
  Rx = [1, 0, 0; 0, cos(q(4)), -sin(q(4)); 0, sin(q(4)), cos(q(4))];
  Ry = [cos(q(5)), 0, sin(q(5)); 0, 1, 0; -sin(q(5)), 0, cos(q(5))];
  axes_ = [[1; 0; 0], Rx(:,2), (Rx * Ry)(:,3)];
  gsmbp_check ("elastic joint: force of the motion", (y(1:3) - force) / max (abs (force)), 1e-9);
  gsmbp_check ("elastic joint: moment of the motion", ...
               (axes_' * y(4:6) - turn) / max (abs (turn)), 1e-8);
end

## many states at once as one by one
function batches (m)
  d = m.sizes;
  n = 19;
  X = m.initial + 0.01 * sin ((1:d.nx)' * (1:n) / 3);
  [Q, U] = deal (X(1:d.nq,:), X(d.nq+1:end,:));
  A = cos (U);
  one = @(f) cell2mat (arrayfun (@(k) f(k)(:), 1:n, "UniformOutput", false));
  same = @(a, b) max (abs (reshape (a, size (b)) - b)(:)) / max (abs (b(:)));
  apart = [same(m.inv_v (0, Q, U, A), one (@(k) m.inv (0, Q(:,k), U(:,k), A(:,k))))
           same(m.mas_v (0, Q), one (@(k) m.mas (0, Q(:,k))))
           same(m.bia_v (0, Q, U), one (@(k) m.bia (0, Q(:,k), U(:,k))))
           same(m.rhs_v (0, X), one (@(k) m.rhs (0, X(:,k))))
           same(m.pnt_v (0, Q), one (@(k) m.pnt (0, Q(:,k))))
           same(m.jpt_v (0, Q, U), one (@(k) m.jpt (0, Q(:,k), U(:,k))))];
  gsmbp_check ("flexible_mounted: batches, of the largest entry", apart, 1e-12);
end

## What a wall exerts on a beam is what a free joint there needs to stand still while all else moves
## as the beam does.
function wall ()
  [a, b] = deal (gsmbp_fixture ("flexible_wall"), gsmbp_fixture ("flexible_loose"));
  n = a.sizes.nu;
  q = 0.02 * cos (1:n)';
  u = 0.5 * sin (1:n)';
  [~, at] = ismember (a.coordinates, b.coordinates);
  [Q, U, A] = deal (zeros (n + 6, 1));
  [Q(at), U(at), A(at)] = deal (q, u, a.rhs (0, [q; u])(n+1:end));
  tau = b.inv (0, Q, U, A);
  T = [cos(0.3), -sin(0.3), 0; sin(0.3), cos(0.3), 0; 0, 0, 1];
  others = setdiff (1:n+6, at);
  expected = [T * tau(others(1:3)); T * tau(others(4:6))];
  gsmbp_check ("a beam at a wall: force and moment of the wall", ...
               (a.out (0, [q; u]) - expected) / max (abs (expected)), 1e-12);
  gsmbp_check ("a beam at a wall: no efforts on the modes", tau(at) / max (abs (expected)), 1e-12);
end
