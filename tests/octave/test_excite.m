## Identification at length: the covariance against 1000 repeats with noise; exciting motions.

function test_excite ()
  m = gsmbp_fixture ("ident_arm");
  randn ("twister", 3);
  repeats (m, ident_motion (m, 60, 0));
  filtered (m, ident_motion (m, 800, 0));
  excited (m);
end

## both sides filtered, each tenth row: the covariance still holds, with the noise given and
## estimated
function filtered (m, d)
  sigma = [0.3 0.1];
  exact = d.tau;
  N = 40;
  for k = 1:N
    d.tau = exact + sigma .* randn (size (exact));
    e = gsmbp_identify (m, d, "sigma", sigma, "decimate", 10);
    x(:,k) = chol (e.covariance)' \ (e.p - e.nominal);
    f = gsmbp_identify (m, d, "weights", "residual", "decimate", 10);
    ratio(:,k) = f.sigma ./ e.sigma;
  end
  n = numel (x);
  gsmbp_check (sprintf ("%d repeats, filtered: sum of squares %.3f of what is expected", N, ...
                        sumsq (x(:)) / n), sumsq (x(:)) / n - 1, 5 * sqrt (2 / n));
  gsmbp_check ("deviations by what is left over those by the noise", mean (ratio, 2) - 1, 0.1);
  gsmbp_check ("the rows", rows (e.residual) == numel (e.t) && numel (e.t) < 80);
end

## 1000 repeats: sums of squares in units of the covariance are chi2 of 7000 freedoms (within 5
## standard deviations), each variance is within 5 of its own
function repeats (m, d)
  sigma = [0.3 0.1];
  exact = d.tau;
  N = 1000;
  for k = 1:N
    d.tau = exact + sigma .* randn (size (exact));
    e = gsmbp_identify (m, d, "sigma", sigma);
    if (k == 1)
      half = inv (chol (e.covariance)');
    end
    x(:,k) = half * (e.p - e.nominal);
  end
  n = rows (x);
  part = sumsq (x(:)) / (n * N);
  gsmbp_check (sprintf ("%d repeats: %d estimates, sum of squares %.4f of what is expected", N, ...
                        n, part), part - 1, 5 * sqrt (2 / (n * N)));
  gsmbp_check ("their variances", var (x, 0, 2) - 1, 5 * sqrt (2 / N));
  C = x * x' / N;
  gsmbp_check ("their covariances", C(! eye (n)), 5 / sqrt (N));
  gsmbp_check ("their means", mean (x, 2), 5 / sqrt (N));
end

function excited (m)
  state = randn ("twister");
  limits = {"speed", [3 4], "acceleration", 12, "period", 5, "harmonics", 3, "starts", 2, ...
            "iterations", 5};
  x = gsmbp_excite (m, limits{:}, "effort", [30 10]);
  gsmbp_check ("the state of randn is as it was", isequal (state, randn ("twister")));
  again = gsmbp_excite (m, limits{:}, "effort", [30 10]);
  gsmbp_check ("the same seed, the same motion", isequal (x.sine, again.sine));
  t = linspace (0, 5, 1201);
  r = gsmbp_inverse (m, x.motion, t);
  use = [max(abs (r.q)) / 2; max(abs (r.u)) ./ [3 4]; max(abs (r.ud)) / 12; ...
         max(abs (r.tau)) ./ [30 10]];
  gsmbp_check ("position, speed, acceleration, effort within their limits", use <= 1 + 1e-3);
  gsmbp_check ("the limits are used", max (use) > 0.6);
  gsmbp_check ("it begins and ends at rest", [r.u([1 end],:); r.ud([1 end],:)], 1e-9);
  w = 2 * pi / 5 * (1:3);
  q = x.offset + x.sine * sin (w' * t) + x.cosine * cos (w' * t);
  gsmbp_check ("the polynomial is the series", r.q' - q, 1e-6);
  gsmbp_check ("each start is improved", x.starts < x.first);
  d = struct ("t", (0:17)' * 5 / 18, "tau", zeros (18, 2));
  for name = {"q", "u", "ud"}
    d.(name{1}) = interp1 (t', r.(name{1}), d.t, "spline");
  end
  e = gsmbp_identify (m, d, "sigma", 1);
  gsmbp_check ("its condition is that of the estimates", e.condition / x.condition - 1, 1e-4);
  y = gsmbp_excite (m, limits{:}, "goal", "determinant");
  gsmbp_check (sprintf ("D-optimal: %.3f, not below %.3f", y.determinant, x.determinant), ...
               y.determinant > x.determinant);
end
