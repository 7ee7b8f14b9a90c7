## The solvers of share/fortran against Octave's own, on easy and on hard matrices; both bodies
## (LAPACK, plain) through the double and the quad build.

function test_solvers ()
  rand ("seed", 1);
  bodies = struct ("double", gsmbp_hand ("motor_pendulum").module, "quad", ...
                   gsmbp_hand ("motor_pendulum", "precision", "quad").module);
  for [f, name] = bodies
    against_octave (f, name);
    small_pivots (f, name);
    singular (f, name);
    constraints (f, name);
  end
end

function x = solve (f, kind, A, b)
  x = f ("solve", [rows(A), columns(b), kind, 1], A, b);
end

function against_octave (f, name)
  ## 150 is beyond the order at which the default body calls LAPACK
  for n = [1, 2, 3, 7, 20, 150]
    A = rand (n) - 0.5;
    P = A * A' + 0.1 * eye (n);
    b = rand (n, 3);
    x = solve (f, 1, P, b);
    ## backward error, a modest multiple of n*eps
    gsmbp_check (sprintf ("%s GSSPD order %d, backward error", name, n), ...
                 norm (P * x - b, Inf) / (norm (P, Inf) * norm (x, Inf)), ...
                 1e-15 * sqrt (n) + 1e-15);
    x = solve (f, 2, A, b);
    gsmbp_check (sprintf ("%s GSLEQ order %d, backward error", name, n), ...
                 norm (A * x - b, Inf) / (norm (A, Inf) * norm (x, Inf)), ...
                 1e-15 * sqrt (n) + 1e-15);
  end
end

## rows of very different units, a zero on the diagonal, Hilbert's matrix, mass ratios of 1e6
function small_pivots (f, name)
  A = diag ([1e-9, 1, 1e9]) * [0, 1, 2; 1, 0, 1; 3, 1, 0];
  x = [1; 2; 3];
  gsmbp_check ([name, " GSLEQ, rows of units 1e-9 to 1e9"], solve (f, 2, A, A * x) - x, 1e-14);
  H = hilb (8);
  x = ones (8, 1);
  wanted = 1e-15 * cond (H);
  gsmbp_check ([name, " GSSPD, Hilbert 8"], solve (f, 1, H, H * x) - x, wanted);
  ## a chain of ten with mass ratios of 1e6: M = S'*D*S, condition about 1e8
  S = triu (ones (10));
  M = S' * diag (10 .^ (-6 * mod (0:9, 2))) * S;
  b = M * ones (10, 1);
  x = solve (f, 1, M, b);
  gsmbp_check ([name, " GSSPD, masses 1 and 1e-6, backward error"], norm (M * x - b) / norm (b), ...
               1e-15);
end

function singular (f, name)
  [~, info] = f ("solve", [3, 1, 2, 1], [1, 2, 3; 4, 5, 6; 7, 8, 9], [1; 2; 3]);
  gsmbp_check ([name, " GSLEQ reports a singular matrix"], info > 0);
  [~, info] = f ("solve", [2, 1, 2, 1], [1, 2; 0, 0], [1; 2]);
  gsmbp_check ([name, " GSLEQ reports a row of zeros"], info > 0);
  [~, info] = f ("solve", [2, 1, 1, 1], [1, 2; 2, 1], [1; 1]);
  gsmbp_check ([name, " GSSPD reports an indefinite matrix"], info == 2);
  [~, info] = f ("solve", [2, 1, 1, 1], [1, 1; 1, 1], [1; 1]);
  gsmbp_check ([name, " GSSPD reports a semidefinite matrix"], info == 2);
end

function [ud, lam, info] = kkt (f, A, H, F, g)
  [ud, lam, info] = f ("kkt", [rows(A), rows(H), 1, 0], A, H, F, g);
end

function constraints (f, name)
  for n = [2, 3, 9, 40]
    m = max (1, floor (0.6 * n));
    A = rand (n) - 0.5;
    A = A * A' + 0.1 * eye (n);
    H = rand (m, n) - 0.5;
    F = rand (n, 1);
    g = rand (m, 1);
    [ud, lam, info] = kkt (f, A, H, F, g);
    residual = [A * ud - H' * lam - F; H * ud - g] / norm ([ud; lam]);
    gsmbp_check (sprintf ("%s GSKKT %d coordinates, %d constraints", name, n, m), ...
                 [residual; info], 1e-13);
  end

  ## redundant rows (one twice, one scaled by 2^-20, a sum): the same accelerations, least-norm
  ## multipliers
  n = 6;
  A = A(1:n,1:n);
  H = round (1024 * H(1:3,1:n)) / 1024;   # few bits: the sums below are exact
  F = F(1:n);
  g = round (1024 * g(1:3)) / 1024;
  ud = kkt (f, A, H, F, g);
  mix = [eye(3); 1, 0, 0; 0, 2^-20, 0; 1, 1, 1];
  [found, lam, info] = kkt (f, A, mix * H, F, mix * g);
  gsmbp_check ([name, " GSKKT redundant rows are reported"], info == 2);
  gsmbp_check ([name, " GSKKT redundant rows, accelerations"], found - ud, 1e-12);
  gsmbp_check ([name, " GSKKT redundant rows, balance"], A * found - (mix * H)' * lam - F, 1e-12);
  gsmbp_check ([name, " GSKKT redundant rows, multipliers of least norm"], ...
               lam - pinv ((mix * H)') * (A * found - F), 1e-12);

  ## rows of different size (metres and radians) are no redundancy
  [found, lam, info] = kkt (f, A, diag ([1e-6, 1, 1e6]) * H, F, diag ([1e-6, 1, 1e6]) * g);
  gsmbp_check ([name, " GSKKT rows of sizes 1e-6 to 1e6, accelerations"], [found - ud; info], ...
               1e-11);

  ## nearly dependent rows are solved to their condition: no squaring of it
  e = 1e-7;
  near = [H(1,:); H(1,:) + e * H(2,:)];
  wanted = kkt (f, A, H(1:2,:), F, g(1:2));
  [found, ~, info] = kkt (f, A, near, F, [g(1); g(1) + e * g(2)]);
  gsmbp_check ([name, " GSKKT rows 1e-7 apart, accelerations"], [found - wanted; info], 1e-7);

  [~, ~, info] = kkt (f, -A, H, F, g);
  gsmbp_check ([name, " GSKKT reports a mass matrix that is not positive"], info == 1);
  [found, lam, info] = kkt (f, A, zeros (2, n), F, [0; 0]);
  gsmbp_check ([name, " GSKKT vanishing rows: the free motion"], [A * found - F; lam; info - 2], ...
               1e-13);
  [found, lam, info] = kkt (f, A(1:2,1:2), [1, 0; 0, 1; 1, 1], F(1:2), [1; 2; 3]);
  gsmbp_check ([name, " GSKKT more rows than coordinates"], [found - [1; 2]; info - 2], 1e-14);
end
