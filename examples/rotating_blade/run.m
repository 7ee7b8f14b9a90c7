## Rotating blade: frequencies over speed (Campbell diagram), and a spin-up with and without the
## stiffening of the spin, beside the modal equations by hand; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## clamped-free shapes and their slopes over x/L, integral of each square 1, and beta
function [shape, slope, b] = clamped_free (i)
  b = fzero (@(b) cos (b) + 1 / cosh (b), (i - 1/2) * pi + [-0.5, 0.5], optimset ("TolX", 0));
  s = (cosh (b) + cos (b)) / (sinh (b) + sin (b));
  shape = @(x) cosh (b*x) - cos (b*x) - s * (sinh (b*x) - sin (b*x));
  slope = @(x) b * (sinh (b*x) + sin (b*x) - s * (cosh (b*x) - cos (b*x)));
endfunction

## modal matrices of the blade by quadrature: stiffness, stiffening by the square of the speed less
## what the turning frame takes, forces by the angular acceleration; the mass is m times the unit
function [K, D, c] = by_hand (p, stiffened)
  m = p.mu * p.L;
  int = @(f) quadgk (f, 0, 1, "AbsTol", 1e-12, "RelTol", 1e-11);
  for i = 1:3
    [shape, slope, b] = clamped_free (i);
    c(i,1) = m * int (@(x) (p.L * x + p.r) .* shape (x));
    K(i,i) = p.EI / p.L ^ 3 * b ^ 4;
    for j = 1:3
      [~, other] = clamped_free (j);
      D(i,j) = -m * (i == j);
      if (stiffened)
        load_ = @(x) (1 - x .^ 2) / 2 + p.r / p.L * (1 - x);
        D(i,j) += m * int (@(x) load_ (x) .* slope (x) .* other (x));
      endif
    endfor
  endfor
endfunction

## the run-up by classical Runge-Kutta of 0.25 ms
function q = run_up (p, t)
  [K, D, c] = by_hand (p, true);
  m = p.mu * p.L;
  speed = @(t) p.w * (t / p.tu - sin (2*pi*t/p.tu) / (2*pi));
  f = @(t, z) [z(4:6); -(K*z(1:3) + speed(t)^2 * D*z(1:3) ...
                           + c * p.w / p.tu * (1 - cos (2*pi*t/p.tu))) / m];
  h = 2.5e-4;
  z = zeros (6, 1);
  q = zeros (numel (t), 3);
  for k = 2:numel (t)
    for s = t(k-1) + h * (0:round ((t(k) - t(k-1)) / h) - 1)
      k1 = f (s, z);
      k2 = f (s + h/2, z + h/2*k1);
      k3 = f (s + h/2, z + h/2*k2);
      z += h/6 * (k1 + 2*k2 + 2*k3 + f (s + h, z + h*k3));
    endfor
    q(k,:) = z(1:3)';
  endfor
endfunction

function y = outputs (m, r)
  y = cell2mat (arrayfun (@(k) m.out (r.t(k), r.x(k,:)'), 1:numel (r.t), "UniformOutput", ...
                          false))';
endfunction

## ------------------------------------------------------------------ frequencies
m = derived_model ("rotating_blade");
speeds = 0:0.25:8;
r = gsmbp_modes (m, m.initial, "spin", "theta", "speeds", speeds, "orders", 1:4, ...
                 "file", "out/figure_campbell.png");
puts ("frequencies [rad/s]: in the plane of rotation (lag), out of it (flap), three modes each\n");
printf ("%12s %10s %10s %10s %10s %10s %10s %26s\n", "speed [rad/s]", "lag 1", "flap 1", ...
        "lag 2", "flap 2", "lag 3", "flap 3", "flap^2 - lag^2 - speed^2");
for k = find (ismember (speeds, [0 2 4 6 8]))
  lag = [];
  flap = [];
  for i = 1:rows (r.frequency)
    if (norm (r.shapes(2:4,i,k)) > 0.5)
      lag(end+1) = r.frequency(i,k);
    else
      flap(end+1) = r.frequency(i,k);
    endif
  endfor
  [lag, flap] = deal (sort (lag), sort (flap));
  printf ("%12g %11.5f %10.5f %10.5f %10.5f %10.5f %10.5f %20.1e\n", speeds(k), ...
          [lag; flap], max (abs (flap .^ 2 - lag .^ 2 - speeds(k) ^ 2)));
endfor
puts ("(the last column is zero for every blade that is alike in both planes)\n\n");

## ------------------------------------------------------------------ spin-up
gsmbp_derive ("rotating_blade_spin_up.mac", "out");
gsmbp_derive ("rotating_blade_linear.mac", "out");
stiffened = gsmbp_build ("rotating_blade_spin_up", "directory", "out");
linear = gsmbp_build ("rotating_blade_linear", "directory", "out");
p = stiffened.par;
tight = {"rtol", 1e-12, "atol", 1e-12};
t = (0:0.05:15)';
up = gsmbp_simulate (stiffened, stiffened.initial, t, tight{:});
after = gsmbp_simulate (gsmbp_set (stiffened, "up", 0), up.x(end,:), (15:0.05:25)', tight{:});
soft = gsmbp_simulate (linear, linear.initial, t, tight{:});
y = [outputs(stiffened, up); outputs(gsmbp_set (stiffened, "up", 0), after)(2:end,:)];
ys = outputs (linear, soft);
all_t = [t; after.t(2:end)];
[least, k] = min (y(:,1));
rest = all_t > 15;
K = by_hand (p, false);
printf ("spin-up to %g rad/s in %g s; first frequency at rest %.4f rad/s\n", p.w, p.tu, ...
        sqrt (K(1,1) / (p.mu * p.L)));
printf ("  the tip lags by up to %.5f m, at %.2f s; afterwards it swings by %.1e m\n", -least, ...
        all_t(k), max (abs (y(rest,1))));
printf ("  moment at the root between %.1f and %.1f N m\n", min (y(:,2)), max (y(:,2)));
q = run_up (p, t);
printf ("  deviation from the modal equations by hand (Runge-Kutta, 0.25 ms): %.1e m\n", ...
        max (abs ((up.x(:,2:4) - q)(:))));
grown = find (abs (ys(:,1)) > 10, 1);
printf ("  without foreshortening the tip is 1 m aside at %.2f s, 10 m at %.2f s\n", ...
        t(find (abs (ys(:,1)) > 1, 1)), t(grown));
printf ("  its stiffness is negative above %.4f rad/s\n\n", sqrt (min (eig (K)) / (p.mu * p.L)));
shown = ys(:,1);
shown(abs (shown) > 2) = NaN;
tip = struct ("y", [y(:,1), [shown; NaN(numel (all_t) - numel (t), 1)]], "names", ...
              {{"second (stiffened)", "linear (not stiffened)"}}, "label", "lag of the tip [m]");
moment = struct ("y", y(:,2), "names", {{"moment"}}, "label", "moment at the root [N m]");
gsmbp_plot ("out/figure_spin_up.png", all_t, tip, moment, "title", "Spin-up to 6 rad/s in 15 s");

## ------------------------------------------------------------------ what it costs
gsmbp_timing (stiffened, 7.5, up.x(151,:));
puts ("\n");
gsmbp_workprecision (stiffened, stiffened.initial, [0 15], "rk4", [2e-2 1e-2 5e-3 2e-3], ...
                     "dp853", 10 .^ -(4:2:12), "file", "out/speed_error.png", "seconds", 0.05);
diary off
