## What holds for every model, at random states: symmetry and definiteness of M, N against M (Mdot -
## 2C skew), power balance, constraints and their rates, linear models against differences; at its
## start the shapes of modes against the linear model. (Against quad precision: test_quad.m.) A
## scene is judged by what it was emitted with.

function test_invariants ()
  scenes = dir (fullfile (fileparts (mfilename ("fullpath")), "..", "scenes", "*.mac"))';
  for scene = scenes
    [~, name] = fileparts (scene.name);
    ## abbreviated: holds to its tolerance, test_abbreviate; springs of 1e8 and 1e10 N/m:
    ## differences see their rounding alone, test_radau_loops, test_trim
    if (any (strcmp (name, {"base_robot_less", "stiff_loop", "trim_stiff"})))
      continue;
    end
    m = gsmbp_fixture (name);
    d = m.sizes;
    joints = of_joints (m);
    m.modal = ! ismember (m.coordinates, joints);
    m.near = {0.1, 0.01}{1 + (numel (joints) < d.nq)};   # beams follow most easily nearer
    rand ("twister", double (name));   # states of its own: a new scene changes no other's
    if (all (ismember ({"mas", "inv", "bia"}, m.subroutines)))
      mass (name, m, d);
    end
    ## pressures need states and steps of their own size: test_fluid, test_library
    fluid = strncmp (name, "fluid_", 6) ...
            || any (strcmp (name, {"library_ports", "trim_pneumatic", "design_press"}));
    ## these balance to their order only: rtest_actuators, rtest_electric
    if (all (ismember ({"rhs", "ene"}, m.subroutines)) && ! fluid ...
          && ! any (strcmp (name, {"variants", "electric_reduced"})))
      power (name, m, d);
    end
    ## where rows are redundant the right-hand side is smooth along the motion only; at the modes of
    ## events: test_event_sensitivity
    if (! fluid && isempty (m.events) && any (strcmp (m.subroutines, "jac")) ...
          && m.json.mobility.rank == d.nlam)
      jacobians (name, m, d);
    end
    if (isempty (m.events) && any (strcmp (m.subroutines, "jac")) && d.nq > 0 ...
          && (d.nlam == 0 || any (strcmp (m.subroutines, "prj"))))
      shapes (name, m, d);
    end
    if (any (strcmp (m.subroutines, "lin")) && any (strcmp (m.subroutines, "inv")))
      motion_model (name, m, d);
    end
    if (d.nlam > 0 && any (strcmp (m.subroutines, "prj")))
      constraints (name, m, d);
    end
  end
end

## inputs; those that are modes of ports are -1, 0 or 1
function v = inputs (m, d)
  v = uniform (d.nv);
  if (! isempty (m.events))
    modes = [m.events.input];
    modes = modes(modes > 0);   # events of the user have none
    v(modes) = randi ([-1, 1], numel (modes), 1);
  end
end

function x = uniform (n)
  x = 2 * rand (n, 1) - 1;
end

## Euler parameters among the coordinates made a unit vector; modal coordinates of beams, which
## belong to sections alone, made small, as the energy cut at degree 2 wants them
function q = unit (m, q)
  q(m.modal) *= 2e-3;
  for set = reshape (m.json.orientation, [], 4 * ! isempty (m.json.orientation))'
    q(set) /= norm (q(set));
  end
end
function names = of_joints (m)
  names = {};
  for joint = m.json.joints(:)'
    if (! strcmp (joint.type, "section"))
      names = [names; cellstr(joint.coordinates)(:)];
    end
  end
end

## a state around the start; loops are closed by the model's own projection
function x = state (m, d)
  x = uniform (d.nx);
  x(d.nq + (1:d.nu)) *= 2;
  if (d.nlam > 0)
    x(1:d.nq) = unit (m, m.initial(1:d.nq) + m.near * uniform (d.nq));
    x = m.prj (0, x);
  else
    x(1:d.nq) = unit (m, m.initial(1:d.nq) + x(1:d.nq));
  end
end

## q' for speeds u (a scene without KIN has q' = u)
function qd = rates (m, q, u)
  qd = u;
  if (any (strcmp (m.subroutines, "kin")))
    qd = m.kin (0, q, u);
  end
end

## sixth-order central difference along each coordinate of x, columns; step chosen for errors near
## 1e-12 of the function's size; F takes many x, a column each
function J = differences (f, x, h)
  n = numel (x);
  F = reshape (f (x(:) + kron (eye (n), h * [1, -1, 2, -2, 3, -3])), [], 6, n);
  D = F(:,[1, 3, 5],:) - F(:,[2, 4, 6],:);
  J = reshape (45 * D(:,1,:) - 9 * D(:,2,:) + D(:,3,:), [], n) / (60 * h);
end

## the handle CALL at many states, a column each
function varargout = many (m, call, varargin)
  [varargout{1:nargout}] = m.module ("many", call, m.cst, varargin{:});
end

## T' = u' (M u' + N) makes u' (Mdot u - 2 N) = 0 for speeds of any kind; Christoffel's symbols
## belong to u = q'
function mass (name, m, d)
  worst = zeros (1, 4);
  definite = plain = true;
  for trial = 1:20
    q = unit (m, pi * uniform (d.nq));
    u = 2 * uniform (d.nu);
    v = zeros (d.nv, 1);
    M = m.mas (0, q);
    [~, fails] = chol (M);
    definite &= ! fails;
    qd = rates (m, q, u);
    Mdot = reshape (differences (@(s) many (m, "mas", 0, q + s .* qd), 0, 1e-3), d.nu, d.nu);
    passive = (m.bia (0, q, u, v) - m.bia (0, q, -u, v)) / 2;
    N = m.bia (0, q, u, v) - m.bia (0, q, 0 * u, v) - passive;
    bias = m.bia (0, q, u, v);
    worst(1:3) = max (worst(1:3), ...
                      [norm(M - M'), abs(u' * (Mdot * u - 2 * N)) / norm(M), ...
                       norm(m.inv (0, q, u, u, v) - M * u - bias) / (norm(M) + norm(bias))]);
    if (d.nq == d.nu && isequal (qd, u))
      dM = reshape (differences (@(q) many (m, "mas", 0, q), q, 1e-3), d.nu, d.nu, d.nq);
      along = reshape (sum (dM .* reshape (u, 1, [], 1), 2), d.nu, d.nu);
      worst(4) = max (worst(4), norm ((Mdot + along - along') / 2 * u - N) / norm (M));
    else
      plain = false;
    end
  end
  gsmbp_check ([name " M symmetric"], worst(1), 1e-16 * ! plain);
  ## their trees hold links without mass
  if (! any (strcmp (name, {"massless_bars", "close_jack"})))
    gsmbp_check ([name " M positive definite"], definite);
  end
  gsmbp_check ([name " u' (Mdot - 2C) u = 0"], worst(2), 1e-9);
  gsmbp_check ([name " inverse dynamics = M u' + bias"], worst(3), 1e-13);
  if (plain)
    gsmbp_check ([name " N = C u with the Christoffel symbols of M"], worst(4), 1e-9);
  end
end

## (T + V + E)' = power in - power dissipated - lambda' phit, the last one for constraints that move
## by themselves
function power (name, m, d)
  worst = 0;
  for trial = 1:20
    x = state (m, d);
    v = inputs (m, d);
    ports = m.events([m.events.input] > 0);
    v([ports.input]) = strcmp ({ports.kind}, "stick");   # friction slides, stops are free
    [xd, ~] = m.rhs (0, x, v);
    drives = 0;
    if (d.nlam > 0)
      [~, phit] = m.con (0, x(1:d.nq), x(d.nq + (1:d.nu)));
      if (any (phit))
        [~, lam, ~] = m.acc (0, x, v);
        drives = lam' * phit;
      end
    end
    energy = @(s) [1, 1, 1, 0, 0] * many (m, "ene", s, x + s .* xd, v);
    E = m.ene (0, x, v);
    rate = differences (energy, 0, 1e-4 / (1 + norm (xd)) ^ 0.5);
    worst = max (worst, ...
                 abs (rate - E(4) + E(5) + drives) / max (1, ...
                   abs (E(4)) + abs (E(5)) + norm (xd)));
  end
  gsmbp_check ([name " power balance"], worst, 1e-9);
end

## A v = e v for each mode that is shown: T z are the coordinates of its shape, the rest of z is the
## best that there is
function shapes (name, m, d)
  [A, ~, ~, ~, info] = m.jac (0, m.initial, zeros (d.nv, 1));
  if (! all (isfinite (A(:))) || info == 1)
    return;   # a car at rest has no slip, points coincide, M is singular
  end
  warning ("off", "gsmbp:equilibrium", "local");
  r = gsmbp_modes (m, m.initial, "start", "project");
  [sys, T, k] = gsmbp_linear (m, 0, r.x, zeros (d.nv, 1));
  A = sys.a .* m.nominal(k)' ./ m.nominal(k);
  S = T(1:d.nq,:) .* m.nominal(k)' ./ m.nominal(1:d.nq);
  worst = [];
  for j = find (any (r.shapes, 1))
    L = A - r.eigenvalues(j) * eye (rows (A));
    L ./= max (abs (L), [], 2);
    s = r.shapes(:,j) ./ m.nominal(1:d.nq);
    z = [L; S] \ [zeros(rows (L), 1); s];
    worst(end+1) = max (norm (L * z), norm (S * z - s)) / norm (s);
  end
  if (! isempty (worst))
    gsmbp_check ([name " shapes of modes are of eigenvectors"], worst, 1e-9);
  end
end

function jacobians (name, m, d)
  worst = 0;
  output = @(x, v) zeros (0, columns (x));
  if (d.ny > 0)
    output = @(x, v) many (m, "out", 0, x, v);
  end
  for trial = 1:10
    do   # away from what the equations themselves tell: orientation angles near their singularity
      x = state (m, d);
      v = inputs (m, d);
      [~, info] = m.rhs (0, x, v);
    until (info != 3)
    [A, B, C, D] = m.jac (0, x, v);
    exact = [A, B; C, D];
    both = @(z) [many(m, "rhs", 0, z(1:d.nx,:), z(d.nx+1:end,:)); ...
                 output(z(1:d.nx,:), z(d.nx+1:end,:))];
    ## the longer step for rounding, the shorter one beside steep places (outputs at their bounds);
    ## of 1 or of the usual size of the state (a pressure, where 1 Pa drowns in rounding)
    usual = [max(1, m.nominal(:)); ones(d.nv, 1)];
    off = @(h, by) norm ((exact - differences (@(z) both (by .* z), [x; v] ./ by, h) ./ by') ...
                         * tangent (m, x, d)) / norm (exact);
    least = Inf;
    for way = {{3e-4, 1}, {3e-5, 1}, {3e-4, usual}, {3e-5, usual}}
      least = min (least, off(way{1}{:}));
      if (least <= 1e-8)
        break;
      end
    end
    worst = max (worst, least);
  end
  gsmbp_check ([name " Jacobians of the state space against differences"], worst, 1e-8);
end

## Off the unit sphere of Euler parameters nothing is promised: the part of a change that leads off
## is taken away.
function P = tangent (m, x, d)
  P = eye (d.nx + d.nv);
  for set = reshape (m.json.orientation, [], 4 * ! isempty (m.json.orientation))'
    P(set, set) -= x(set) * x(set)';
  end
end

## the paper's linear model about a motion: M, B = dN/du, C = d(M u' + N + G)/dq
function motion_model (name, m, d)
  left_out = 0;
  worst = zeros (1, 3);
  for trial = 1:10
    q = unit (m, uniform (d.nq));
    u = 2 * uniform (d.nu);
    ud = 5 * uniform (d.nu);
    v = inputs (m, d);
    [M, B, C] = m.lin (0, q, u, ud, v);
    by_u = @(u) many (m, "inv", 0, q, u, ud, v);
    by_q = @(q) many (m, "inv", 0, q, u, ud, v);
    B_wanted = differences (by_u, u, 1e-2);
    C_wanted = differences (by_q, q, 2.5e-4);   # springs between points that nearly meet
    if (apart (C_wanted, differences (by_q, q, 5e-4)) ...
        || apart (B_wanted, differences (by_u, u, 5e-3)))
      left_out++;   # a stop begins within the step, friction turns, two points nearly meet
      continue;
    end
    worst = max (worst, ...
                 [norm(M - m.mas (0, q)) / norm(M), ...
                  norm(B - B_wanted) / max(1, norm (B_wanted)), ...
                  norm(C - C_wanted) / max(1, norm (C_wanted))]);
  end
  if (left_out > 2)
    gsmbp_check ([name " linear model about a motion: states left out"], left_out, 2);
  end
  names = {"M", "B", "C"};
  for k = 1:3
    gsmbp_check ([name " linear model about a motion, " names{k}], worst(k), ...
                 [1e-14, 1e-10, 1e-10](k));
  end
end

## differences of two steps that do not agree: they can tell nothing about a linear model
function yes = apart (A, B)
  yes = norm (A - B) > 1e-9 * max (1, norm (A));
end

## HC u is the rate of phi (but of constraints on speeds), GAM = -(HC u + PHIT)' at u' = 0, and a
## projected state satisfies all
function constraints (name, m, d)
  worst = zeros (1, 4);
  holonomic = setdiff (1:d.nlam, m.json.speed_rows(:)');
  for trial = 1:20
    q = unit (m, m.initial(1:d.nq) + 0.5 * uniform (d.nq));
    u = 2 * uniform (d.nu);
    [phi, phit, H, gam] = m.con (0, q, u);
    qd = rates (m, q, u);
    move = differences (@(s) many (m, "con", 0, q + s .* qd, u), 0, 1e-3);
    worst(1) = max ([worst(1); abs(H * u - move)(holonomic)]);
    rate = @(s) velocity_rows (m, s, q + s .* qd, u);
    worst(2) = max (worst(2), norm (gam + differences (rate, 0, 1e-3)) / max (1, norm (gam)));
    x = state (m, d);
    [phi, phit, H] = m.con (0, x(1:d.nq), x(d.nq + (1:d.nu)));
    worst(3) = max (worst(3), norm (phi));
    worst(4) = max (worst(4), norm (H * x(d.nq + (1:d.nu)) + phit));
  end
  gsmbp_check ([name " constraint Jacobian against differences"], worst(1), 1e-9);
  gsmbp_check ([name " constraint right-hand side against differences"], worst(2), 1e-8);
  gsmbp_check ([name " projected state closes the loop"], worst(3), 1e-12);
  gsmbp_check ([name " projected speeds keep it closed"], worst(4), 1e-12);
end

function r = velocity_rows (m, t, q, u)
  [~, phit, H] = many (m, "con", t, q, u);
  r = reshape (sum (H .* u', 2), rows (phit), []) + phit;
end
