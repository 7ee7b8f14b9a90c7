## Total least squares in gsmbp_identify: 0.5 mm and 0.05 degrees of noise in the positions, 1 N and
## 0.2 N*m in the efforts. Repeats with seeded noise: how often the estimates are within two of
## their standard deviations, their means, their scatter, all against the Cramer-Rao bound of the
## experiment (crane_motion.m). REPEATS=1000 (make test-identify) samples every 5 ms, else 20
## repeats sample every 10 ms and the tolerances are wider by 3.5 standard errors of so few.

function test_total ()
  N = str2double (getenv ("REPEATS"));
  step = 0.005;
  if (isnan (N))
    [N, step] = deal (20, 0.01);
  end
  m = gsmbp_fixture ("ident_crane");
  d = crane_motion ((0:step:5)');
  [noise_q, noise] = deal ([5e-4, 0.05*pi/180], [1, 0.2]);
  exact (m, d);
  repeats (m, d, noise_q, noise, N);
  uneven (m, crane_motion ((0:0.005:5)'), noise_q, noise);
  refused (m, d);
end

function exact (m, d)
  off = gsmbp_identify (m, d, "method", "total");
  gsmbp_check ("the equations written by hand: names", strcmp (off.names, d.names));
  gsmbp_check ("... exact data: estimates", off.p - d.p, 1e-7);
end

function repeats (m, d, noise_q, noise, N)
  bound = sqrt (diag (d.bound (noise_q, noise)));
  warning ("off", "gsmbp:identify", "local");
  randn ("twister", 48);
  for k = 1:N
    [f, s] = noisy (m, d, noise_q, noise);
    e = gsmbp_identify (m, f, "method", "total");
    [p(:,k), sigma(:,k), found(:,k)] = deal (e.p, e.sigma, [e.noise; e.noise_q]);
    plain(:,k) = e.plain.p;
  end
  more = 3.5 / sqrt (N);
  if (N >= 1000)
    more = 0;
  end
  off = p - d.p;
  inside = mean (abs (off) <= 2 * sigma, 2);
  told = sprintf (" %.1f", 100 * inside);
  few = sqrt (0.955 * 0.045) * more;
  gsmbp_check (["within two standard deviations:" told " %"], ...
               inside >= 0.93 - few & inside <= 0.975 + few);
  mean_ = mean (off, 2) ./ bound;
  gsmbp_check (["mean errors over the bound:" sprintf(" %.3f", mean_)], mean_, 0.15 + more);
  ratio = std (off, 0, 2) ./ mean (sigma, 2);
  gsmbp_check (["observed over stated deviations:" sprintf(" %.3f", ratio)], ratio - 1, ...
               0.1 + more / sqrt (2));
  over = mean (sigma, 2) ./ bound;
  gsmbp_check (["stated deviations over the Cramer-Rao bound:" sprintf(" %.3f", over)], ...
               over > 0.97 & over < 1.3);
  gsmbp_check ("observed deviations over the bound", std (off, 0, 2) ./ bound < 1.3 + more);
  gsmbp_check ("noise of efforts and positions", mean (found, 2) ./ [noise, noise_q]' - 1, 0.03);
  gsmbp_check (sprintf ("the plain estimate is biased: mR by %.1f of the bound", ...
                        mean (plain(1,:) - d.p(1)) / bound(1)), ...
               mean (plain(1,:) - d.p(1)) < -20 * bound(1));
end

## as gsmbp_measured gives it with a cutoff at 20 Hz
function [f, s] = noisy (m, d, noise_q, noise)
  n = numel (d.t);
  s = struct ("t", d.t, "q", d.q + noise_q .* randn (n, 2), "tau", d.tau + noise .* randn (n, 2));
  f = gsmbp_measured (m, s, "cutoff", 20);
end

## missing rows and times that jitter; sigma given; further columns, dry friction among them, with
## which full steps end in a cycle
function uneven (m, d, noise_q, noise)
  warning ("off", "gsmbp:identify", "local");
  randn ("twister", 7);
  keep = true (size (d.t));
  keep([100:110, 200, 330:342]) = false;
  t = d.t(keep);
  t(2:end-1) += 1e-3 * (2 * mod ((2:numel (t) - 1)' * 0.618, 1) - 1);
  d = crane_motion (t);
  f = struct ("t", t, "q", d.q + noise_q .* randn (size (d.q)), "tau", d.tau ...
              + noise .* randn (size (d.q)) + [0.7, 0] .* sign (d.u));
  says ("needs times at equal distances; from t = .*; take the option cutoff .spline.", ...
        @() gsmbp_measured (m, f, "cutoff", 20));
  f = gsmbp_measured (m, f, "cutoff", "spline");
  gsmbp_check ("uneven times: speeds and accelerations of a spline", ...
               [norm(f.u - d.u)/norm(d.u), norm(f.ud - d.ud)/norm(d.ud)] < [0.01, 0.1]);
  e = gsmbp_identify (m, f, "method", "total", "coulomb", "s", "offset", "phi", "fixed", ...
                      "pin_friction", "sigma", noise);
  names = {"s_coulomb"; "phi_offset"};
  gsmbp_check ("uneven times: names", strcmp (e.names, [d.names(1:5); names]));
  true_ = d.p;
  nominal = gsmbp_identify (m, f).nominal;
  f.raw.tau(:,2) += (nominal(6) - d.p(6)) * d.u(:,2);   # as fixed
  e = gsmbp_identify (m, f, "method", "total", "coulomb", "s", "offset", "phi", "fixed", ...
                      "pin_friction", "sigma", noise);
  gsmbp_check ("uneven times: estimates, in their standard deviations", ...
               (e.p - [true_(1:5); 0.7; 0]) ./ e.sigma, 3.5);
  gsmbp_check ("... sigma as given", e.noise - noise', 1e-15);
  c = gsmbp_consistent (m, gsmbp_identify (m, f, "method", "total"));
  gsmbp_check ("... the nearest bodies", c.gain < 10);
end

function refused (m, d)
  motors = struct ("coordinate", "s", "ratio", 1, "current", "i", "voltage", "v");
  few = structfun (@(x) x, d, "UniformOutput", false);
  for name = {"t", "q", "u", "ud", "tau"}
    few.(name{1}) = d.(name{1})(1:12,:);
  end
  says ("12 times are too few for a smooth motion", ...
        @() gsmbp_identify (m, few, "method", "total"));
  d.other = struct ("i", d.t, "v", d.t);
  says ("option method: total takes measured efforts; found motors", ...
        @() gsmbp_identify (m, d, "method", "total", "motors", motors));
end

function says (text, f)
  gsmbp_check (text, ! isempty (regexp (gsmbp_complaint (f), text)));
end
