## Gains of gsmbp_control on random systems against solutions by other ways: Riccati's equation by
## the sign function of its Hamiltonian matrix, the sampled one by doubling, one input's poles by
## Ackermann's formula on the controllability matrix, noise between samples by quadrature; errors of
## the size of the gain, divided by the condition of the equation.

function test_gains ()
  pkg load control
  rand ("twister", 5);
  randn ("twister", 5);
  worst = zeros (1, 7);
  for trial = 1:30
    found = [continuous(), integral(), sampled(), late(), placed()];
    worst = max (worst, found);
  end
  names = {"LQR", "Kalman filter", "LQR with integrals", "sampled LQR", "sampled Kalman filter", ...
           "sampled LQR, inputs late", "poles, one input"};
  for k = 1:numel (names)
    gsmbp_check (["gains of 30 random systems, by their condition: " names{k}], worst(k), 1e-12);
  end
  several ();
  perturbed ();
end

## 2 to 7 states, up to three inputs and outputs, of no particular size
function [A, B, C, Q, R, W, V] = system_ ()
  n = randi ([2, 7]);
  [m, p] = deal (randi ([1, 3]), randi ([1, min(3, n)]));
  S = diag (10 .^ (2 * rand (n, 1) - 1));
  [A, B, C] = deal (S \ randn (n) * S, S \ randn (n, m), randn (p, n) * S);
  [Q, W] = deal (positive (n), positive (n));
  [R, V] = deal (positive (m) + 0.1 * eye (m), positive (p) + 0.1 * eye (p));
end

function Q = positive (n)
  Q = randn (n);
  Q = Q * Q' / n + 0.01 * eye (n);
end

function e = continuous ()
  [A, B, C, Q, R, W, V] = system_ ();
  c = gsmbp_control (ss (A, B, C, 0), [], "lqg", "Q", Q, "R", R, "W", W, "V", V);
  [P, k] = care_ (A, B, Q, R);
  e = away (c.K, R \ (B' * P), k);
  [P, k] = care_ (A', C', W, V);
  e(2) = away (c.L, P * C' / V, k);
end

function e = integral ()
  [A, B, C, Q, R] = system_ ();
  [n, C] = deal (rows (A), C(1,:));
  Qi = 1 + rand ();
  names = [strcat("x", num2cell ("1":char ("0" + n))), {"y"}];
  sys = ss (A, B, [eye(n); C], 0, "OutputName", names);
  c = gsmbp_control (sys, [], "lqr", "Q", Q, "R", R, "Qi", Qi, "integral", "y");
  F = [A, zeros(n, 1); -C, 0];
  H = [B; zeros(1, columns (B))];
  [P, k] = care_ (F, H, blkdiag (Q, Qi), R);
  e = away (c.K, R \ (H' * P), k);
end

function e = sampled ()
  [A, B, C, Q, R, W, V] = system_ ();
  h = 0.2 / norm (A);
  c = gsmbp_control (ss (A, B, C, 0), [], "lqg", "Q", Q, "R", R, "W", W, "V", V, "period", h);
  [F, H] = held (A, B, h);
  [P, k] = dare_ (F, H, Q, R);
  e = away (c.K, (R + H' * P * H) \ (H' * P * F), k);
  Wd = 0;
  [x, w] = gauss ();
  for i = 1:numel (x)
    E = expm (A * h * x(i));
    Wd += h * w(i) * E * W * E';
  end
  [P, k] = dare_ (F', C', Wd, V);
  e(2) = away (c.L, F * P * C' / (C * P * C' + V), k);
end

## the delay is longer than a period
function e = late ()
  [A, B, C, Q, R] = system_ ();
  [n, m] = size (B);
  h = 0.2 / norm (A);
  c = gsmbp_control (ss (A, B, eye (n), 0), [], "lqr", "Q", Q, "R", R, "period", h, "delay", ...
                     1.3 * h);
  [F, H] = held (A, B, h);
  [~, rest] = held (A, B, 0.7 * h);
  F = [F, rest, H - rest; zeros(m, n + 2 * m); zeros(m, n), eye(m), zeros(m)];
  H = [zeros(n, m); eye(m); zeros(m)];
  [P, k] = dare_ (F, H, blkdiag (Q, zeros (2 * m)), R);
  e = away (c.K, (R + H' * P * H) \ (H' * P * F), k);
end

function e = placed ()
  n = randi ([2, 6]);
  [A, B] = deal (randn (n), randn (n, 1));
  poles = -1 - 3 * rand (n, 1);
  poles(1:2) = poles(1) + 1i * [1, -1];
  c = gsmbp_control (ss (A, B, eye (n), 0), [], "place", "poles", poles);
  T = B;
  for k = 2:n
    T = [B, A * T];
  end
  e = away (c.K, (1:n == n) / T * real (polyvalm (poly (poles), A)), cond (T));
end

## several inputs: the poles are those that were asked for, by the condition of the eigenvectors
function several ()
  worst = 0;
  for trial = 1:20
    n = randi ([3, 7]);
    [A, B] = deal (randn (n), randn (n, 2));
    poles = sort (-1 - 3 * rand (n, 1));
    c = gsmbp_control (ss (A, B, eye (n), 0), [], "place", "poles", poles);
    [V, D] = eig (A - B * c.K);
    gap = norm (sort (real (diag (D))) - poles, Inf) / norm (A - B * c.K);
    worst = max (worst, gap / cond (V));
  end
  gsmbp_check ("poles of 20 random systems with two inputs, by their condition", worst, 1e-13);
end

## the measure can fail: another weight, by 1e-9 of it, is seen
function perturbed ()
  [A, B, C, Q, R] = system_ ();
  c = gsmbp_control (ss (A, B, eye (rows (A)), 0), [], "lqr", "Q", Q, "R", R);
  [P, k] = care_ (A, B, Q * (1 + 1e-9), R);
  gsmbp_check ("gains: a weight that is off by 1e-9 is seen", ...
               away (c.K, R \ (B' * P), 1) > 1e-12);
end

function e = away (found, wanted, condition)
  e = max (abs (found - wanted)(:)) / max (abs (wanted(:))) / condition;
end

## P and its condition, by the sign of the Hamiltonian matrix
function [P, k] = care_ (A, B, Q, R)
  n = rows (A);
  G = B / R * B';
  Z = [A, -G; -Q, -A'];
  for i = 1:60
    c = abs (det (Z)) ^ (-1 / (2 * n));
    next = (c * Z + inv (c * Z)) / 2;
    done = norm (next - Z, 1) < 1e-14 * norm (Z, 1);
    Z = next;
    if (done)
      break;
    end
  end
  P = -[Z(1:n,n+1:end); Z(n+1:end,n+1:end) + eye(n)] \ [Z(1:n,1:n) + eye(n); Z(n+1:end,1:n)];
  F = A - G * P;
  L = kron (eye (n), F') + kron (F', eye (n));
  k = norm (inv (L)) * (norm (Q) + 2 * norm (A) * norm (P) + norm (G) * norm (P) ^ 2) / norm (P);
end

## P and its condition, by doubling
function [P, k] = dare_ (A, B, Q, R)
  n = rows (A);
  [F, G, P] = deal (A, B / R * B', Q);
  for i = 1:50
    W = eye (n) + G * P;
    more = F' * P / W * F;
    [F, G] = deal (F / W * F, G + F / W * G * F');
    P += more;
    if (norm (more, 1) < 1e-16 * norm (P, 1))
      break;
    end
  end
  closed = A - B * ((R + B' * P * B) \ (B' * P * A));
  L = eye (n ^ 2) - kron (closed', closed');
  k = norm (inv (L)) * (norm (Q) + 2 * norm (A) ^ 2 * norm (P) ...
                        + norm (A) ^ 2 * norm (B / R * B') * norm (P) ^ 2) / norm (P);
end

function [F, H] = held (A, B, h)
  [n, m] = size (B);
  X = expm ([A, B; zeros(m, n + m)] * h);
  [F, H] = deal (X(1:n,1:n), X(1:n,n + 1:end));
end

## ten points of Gauss and Legendre in [0, 1]
function [x, w] = gauss ()
  b = (1:9) ./ sqrt (4 * (1:9) .^ 2 - 1);
  [V, D] = eig (diag (b, 1) + diag (b, -1));
  [x, w] = deal ((diag (D) + 1) / 2, V(1,:)' .^ 2);
end
