## Every compiled reference case against the independent Newton-Euler formulation at random states
## (seeded), in double precision on both sides.

function test_independent_models ()
  cases = ...
      {"case_01a", "01a_puma560_akb_3link"; "case_02a", "02a_slidercrank_inverse"; "case_03a", ...
       "03a_fourbar";
           "case_07c", "07c_spatial_triple_pendulum"; "case_15a", "15a_cart_pole_linear"};
  rand ("twister", 1);
  for k = 1:rows (cases)
    m = gsmbp_fixture (cases{k, 1});
    tree (cases{k, 1}, m, m.sizes.nv, gsmbp_case (cases{k, 2}));
    if (any (strcmp (cases{k, 1}, {"case_02a", "case_03a"})))
      loop (cases{k, 1}, m, gsmbp_case (cases{k, 2}));
    end
  end
end

## the reduced tree, inputs zero
function tree (name, m, nv, ne)
  n = numel (ne.body);
  v = zeros (nv, 1);
  worst = zeros (1, 4);
  for trial = 1:100
    q = pi * (2 * rand (n, 1) - 1);
    u = 4 * rand (n, 1) - 2;
    ud = 4 * rand (n, 1) - 2;
    [M, c, G] = ne_terms (ne, q, u);
    free = ne;
    free.loop = [];
    friction = [ne.joint.damping]' .* u;
    tau = ne_inverse (free, q, u, ud);
    found = {m.mas(0, q), m.bia(0, q, u, v), m.inv(0, q, u, ud, v), m.fwd(0, q, u, v, tau)};
    wanted = {M, c + G + friction, tau, ud};
    worst = max (worst, cellfun (@(a, b) max (abs (a - b)(:)) / max (abs (b(:))), found, wanted));
  end
  names = {"M", "N + G + friction", "inverse dynamics", "forward dynamics"};
  for k = 1:4
    gsmbp_check ([name " " names{k} ", 100 random states, Newton-Euler"], worst(k), 1e-12);
  end
end

## loops at closed states: accelerations and multipliers of a free motion
function loop (name, m, ne)
  guess = {[], [0.3; -0.4; 0.1], [1.1; -0.74; 1.23]}{1 + strcmp(name, "case_02a") + 2 ...
        * strcmp(name, "case_03a")};
  worst = zeros (1, 4);
  for trial = 1:50
    start = guess + 0.2 * (rand (3, 1) - 0.5);
    [q, u] = ne_close (ne, start, 1, [8 * rand - 4; 0; 0], zeros (3, 1));
    k = ne_rows (ne, q, u);
    H = k.L * (k.J \ k.E);
    gamma = k.gamma_loop - k.L * (k.J \ k.gamma);
    [ud, lam] = ne_forward (ne, q, u, zeros (3, 1));
    [phi, phit, HC, gam] = m.con (0, q, u);
    xd = m.rhs (0, [q; u], 0);
    worst = max (worst, ...
                 [norm(phi), norm(HC - H), norm(gam - gamma) / max(1, norm (gamma)), ...
                  norm(xd(4:6) - ud) / norm(ud)]);
  end
  names = {"loop closed", "constraint Jacobian", "constraint right-hand side", ...
           "accelerations with the loop"};
  for k = 1:4
    gsmbp_check ([name " " names{k} ", 50 random states, Newton-Euler"], worst(k), 1e-12);
  end
end
