## What holds for every model, at random states: symmetry and definiteness of M, N against M (Mdot - 2C skew), power balance, constraints and their
## rates, linear models against differences. (Against quad precision: test_quad.m.)

function test_invariants ()
  rand ("twister", 2);
  for scene = dir (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.mac"))'
    [~, name] = fileparts (scene.name);
    m = gsmbp_fixture (name);
    d = m.sizes;
    mass (name, m, d);
    if (! strcmp (name, "variants"))   # qs1 balances to the order of L only: rtest_actuators
      power (name, m, d);
    end
    jacobians (name, m, d);
    motion_model (name, m, d);
    if (d.nlam > 0)
      constraints (name, m, d);
    end
  end
end

function x = uniform (n)
  x = 2 * rand (n, 1) - 1;
end

## a state; loops are closed by the model's own projection
function x = state (m, d)
  x = uniform (d.nx);
  x(d.nq + (1:d.nu)) *= 2;
  if (d.nlam > 0)
    x(1:d.nq) = start (m, d) + 0.1 * uniform (d.nq);
    x = m.prj (0, x);
  end
end

function q = start (m, d)
  q = m.initial(1:d.nq);
end

## fourth-order central difference along each coordinate of x, columns; step chosen for errors near 1e-12 of the function's size
function J = differences (f, x, h)
  for k = 1:numel (x)
    e = h * (1:numel (x) == k)';
    J(:, k) = (8 * (f(x + e) - f(x - e)) - (f(x + 2 * e) - f(x - 2 * e))) / (12 * h);
  end
end

function mass (name, m, d)
  worst = zeros (1, 4);
  definite = true;
  for trial = 1:20
    q = pi * uniform (d.nq);
    u = 2 * uniform (d.nu);
    v = zeros (d.nv, 1);
    M = m.mas (0, q);
    [~, fails] = chol (M);
    definite &= ! fails;
    dM = reshape (differences (@(q) m.mas (0, q)(:), q, 1e-3), d.nu, d.nu, d.nq);
    Mdot = sum (dM .* reshape (u, 1, 1, []), 3);
    C = (Mdot + squeeze (sum (dM .* reshape (u, 1, [], 1), 2)) - squeeze (sum (dM .* reshape (u, 1, [], 1), 2))') / 2;
    passive = (m.bia (0, q, u, v) - m.bia (0, q, -u, v)) / 2;
    N = m.bia (0, q, u, v) - m.bia (0, q, 0 * u, v) - passive;
    worst = max (worst, [norm(M - M'), abs(u' * (Mdot * u - 2 * N)) / norm(M), norm(C * u - N) / norm(M), norm(m.inv (0, q, u, u, v) - M * u - m.bia (0, q, u, v)) / norm(M)]);
  end
  gsmbp_check ([name " M symmetric"], worst(1), 0);
  gsmbp_check ([name " M positive definite"], definite);
  gsmbp_check ([name " u' (Mdot - 2C) u = 0"], worst(2), 1e-10);
  gsmbp_check ([name " N = C u with the Christoffel symbols of M"], worst(3), 1e-10);
  gsmbp_check ([name " inverse dynamics = M u' + bias"], worst(4), 1e-13);
end

## (T + V + E)' = power in - power dissipated
function power (name, m, d)
  worst = 0;
  for trial = 1:20
    x = state (m, d);
    v = uniform (d.nv);
    xd = m.rhs (0, x, v);
    energy = @(s) [1, 1, 1, 0, 0] * m.ene (0, x + s * xd, v)(:);
    E = m.ene (0, x, v);
    rate = differences (energy, 0, 1e-4 / (1 + norm (xd)) ^ 0.5);
    worst = max (worst, abs (rate - E(4) + E(5)) / max (1, abs (E(4)) + abs (E(5)) + norm (xd)));
  end
  gsmbp_check ([name " power balance"], worst, 1e-9);
end

function jacobians (name, m, d)
  worst = 0;
  output = @(x, v) zeros (0, 1);
  if (d.ny > 0)
    output = @(x, v) m.out (0, x, v);
  end
  for trial = 1:10
    x = state (m, d);
    v = uniform (d.nv);
    [A, B, C, D] = m.jac (0, x, v);
    exact = [A, B; C, D];
    both = @(z) [m.rhs(0, z(1:d.nx), z(d.nx+1:end)); output(z(1:d.nx), z(d.nx+1:end))];
    worst = max (worst, norm (exact - differences (both, [x; v], 1e-3)) / norm (exact));
  end
  gsmbp_check ([name " Jacobians of the state space against differences"], worst, 1e-8);
end

## the paper's linear model about a motion: M, B = dN/dq', C = d(M q'' + N + G)/dq
function motion_model (name, m, d)
  worst = zeros (1, 3);
  for trial = 1:10
    q = uniform (d.nq);
    u = 2 * uniform (d.nu);
    ud = 5 * uniform (d.nu);
    v = uniform (d.nv);
    [M, B, C] = m.lin (0, q, u, ud, v);
    B_wanted = differences (@(u) m.inv (0, q, u, ud, v), u, 1e-2);
    C_wanted = differences (@(q) m.inv (0, q, u, ud, v), q, 1e-3);
    worst = max (worst, [norm(M - m.mas (0, q)) / norm(M), norm(B - B_wanted) / max(1, norm (B_wanted)), norm(C - C_wanted) / max(1, norm (C_wanted))]);
  end
  names = {"M", "B", "C"};
  for k = 1:3
    gsmbp_check ([name " linear model about a motion, " names{k}], worst(k), [1e-14, 1e-10, 1e-10](k));
  end
end

## HC is the gradient of phi, GAM = -(HC u + PHIT)' at u' = 0, and a projected state satisfies all
function constraints (name, m, d)
  worst = zeros (1, 4);
  for trial = 1:20
    q = uniform (d.nq);
    u = 2 * uniform (d.nu);
    [phi, phit, H, gam] = m.con (0, q, u);
    rate = @(s) velocity_rows (m, s, q + s * u, u);
    worst(1) = max (worst(1), norm (H - differences (@(q) m.con (0, q, u), q, 1e-3)));
    worst(2) = max (worst(2), norm (gam + differences (rate, 0, 1e-3)) / max (1, norm (gam)));
    x = state (m, d);
    [phi, phit, H] = m.con (0, x(1:d.nq), x(d.nq + (1:d.nu)));
    worst(3) = max (worst(3), norm (phi));
    worst(4) = max (worst(4), norm (H * x(d.nq + (1:d.nu)) + phit));
  end
  gsmbp_check ([name " constraint Jacobian against differences"], worst(1), 1e-10);
  gsmbp_check ([name " constraint right-hand side against differences"], worst(2), 1e-9);
  gsmbp_check ([name " projected state closes the loop"], worst(3), 1e-13);
  gsmbp_check ([name " projected speeds keep it closed"], worst(4), 1e-13);
end

function r = velocity_rows (m, t, q, u)
  [~, phit, H] = m.con (t, q, u);
  r = H * u + phit;
end
