## Scenes made by chance (seeded) against the independent Newton-Euler formulation: trees, and rings with a spatial loop joint.
## GSMBP_RANDOM is the number of trees (default 3); half as many rings. make test-random asks for more.

function test_random ()
  count = str2double (getenv ("GSMBP_RANDOM"));
  if (isnan (count))
    count = 3;
  end
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  for seed = 1:count
    tree (sprintf ("tree_%d", seed), seed);
  end
  for seed = 1:ceil (count / 2)
    ring (sprintf ("ring_%d", seed), seed);
  end
end

## derived and built; [] if that failed
function [m, ne] = model (name, seed, kind)
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  file = fullfile (getenv ("GSMBP_TEST_DIR"), [name ".mac"]);
  ne = random_scene (seed, kind, file);
  derive = fullfile (fileparts (mfilename ("fullpath")), "..", "..", "share", "make", "derive");
  [code, text] = system (sprintf ("'%s' '%s' '%s' 2>&1", derive, file, folder));
  if (code)
    error ("%s: %s", name, text);
  end
  m = gsmbp_fixture (name);
end

function tree (name, seed)
  [m, ne] = model (name, seed, "tree");
  n = m.sizes.nq;
  worst = zeros (1, 4);
  for trial = 1:10
    [q, u, ud] = deal (pi * (2 * rand (n, 1) - 1), 4 * rand (n, 1) - 2, 4 * rand (n, 1) - 2);
    tau = ne_inverse (ne, q, u, ud);
    [T, V] = ne_energy (ne, q, u);
    [T0, V0] = ne_energy (ne, 0 * q, 0 * u);
    E = m.ene (0, [q; u]) - m.ene (0, zeros (2 * n, 1));
    xd = m.rhs (0, [q; u]);
    ud0 = ne_forward (ne, q, u, zeros (n, 1));
    worst = max (worst, [norm(m.mas (0, q) - ne_terms (ne, q, u)) / norm(m.mas (0, q)), norm(m.inv (0, q, u, ud) - tau) / norm(tau), ...
                         norm(xd(n+1:end) - ud0) / norm(ud0), norm(E(1:2)(:) - [T; V - V0]) / (T + abs (V - V0))]);
  end
  report (sprintf ("%s (%d links)", name, n), worst, {"mass matrix", "inverse dynamics", "accelerations", "energies"});
end

function ring (name, seed)
  [m, ne] = model (name, seed, "loop");
  n = m.sizes.nq;
  worst = zeros (1, 4);
  for trial = 1:5
    ## a closed position near q = 0: independent coordinates from the loop's own rank
    k = ne_rows (ne, zeros (n, 1), zeros (n, 1));
    [~, ~, order] = qr (k.L * (k.J \ k.E), 0);
    independent = sort (order(rank (k.L * (k.J \ k.E)) + 1:end));
    u = zeros (n, 1);
    u(independent) = 2 * rand (numel (independent), 1) - 1;
    start = zeros (n, 1);
    start(independent) = 0.1 * u(independent);
    [q, u] = ne_close (ne, start, independent, u, zeros (n, 1));
    k = ne_rows (ne, q, u);
    [phi, phit, H, gam] = m.con (0, q, u);
    xd = m.rhs (0, [q; u]);
    ud = ne_forward (ne, q, u, zeros (n, 1));
    worst = max (worst, [norm(phi), norm(H * null (k.L * (k.J \ k.E))) / norm(H), norm(H * u + phit) / norm(u), norm(xd(n+1:end) - ud) / norm(ud)]);
  end
  gsmbp_check ([name " has as many constraints as the loop"], rank (H) == rank (k.L));
  report (name, worst, {"loop closed", "Jacobian", "closed speeds", "accelerations"});
end

## 1e-11: forward dynamics multiplies rounding by the condition of M, up to a few hundred here
function report (name, worst, names)
  for k = 1:numel (worst)
    gsmbp_check ([name ": " names{k}], worst(k), 1e-11);
  end
end
