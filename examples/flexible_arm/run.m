## Flexible arm with a DC motor: poles, the zeros from the motor's voltage to a sensor somewhere on
## the arm, the first moments of a step; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## finite zeros of one input and one output
function z = zeros_of (A, B, C, D)
  n = rows (A);
  z = eig ([A, B; C, D], blkdiag (eye (n), 0));
  z = z(isfinite (z) & abs (z) < 1e5);
endfunction

## squares of zeros that come in pairs of opposite ones, the smallest first
function s = squares (z)
  z = z(real (z) > 1e-6 * abs (z) | (abs (real (z)) <= 1e-6 * abs (z) & imag (z) > 0));
  s = z .^ 2;
  s(abs (imag (s)) <= 1e-6 * abs (s)) = real (s(abs (imag (s)) <= 1e-6 * abs (s)));
  [~, order] = sort (abs (s));
  s = s(order);
endfunction

function text = in_words (s)
  if (imag (s) != 0)
    text = sprintf ("+-%.1f%+.1f i", real (sqrt (s)), imag (sqrt (s)));
  elseif (s < 0)
    text = sprintf ("%.3f i", sqrt (-s));
  else
    text = sprintf ("+-%.3f  ", sqrt (s));
  endif
  text = sprintf ("%18s", text);
endfunction

## first frequencies of a cantilever with a mass MU and an inertia JN (of its own and length) at its
## tip, over sqrt (E I/(m L^3)): roots of the characteristic equation
function w = cantilever (mu, jn, n)
  f = @(b) (1 + cos (b) .* cosh (b) + mu * b .* (cos (b) .* sinh (b) - sin (b) .* cosh (b)) ...
            - jn * b .^ 3 .* (cos (b) .* sinh (b) + sin (b) .* cosh (b)) ...
            + mu * jn * b .^ 4 .* (1 - cos (b) .* cosh (b))) ./ cosh (b);
  b = 0.01:0.01:20;
  k = find (diff (sign (f (b))) != 0);
  w = arrayfun (@(k) fzero (f, b(k:k+1), optimset ("TolX", 0)) ^ 2, k(1:n))';
endfunction

m = derived_model ("flexible_arm");
p = m.par;
unit = sqrt (p.EI / (p.ma * p.L ^ 3));
x0 = m.initial;
quiet_ = gsmbp_set (m, "zeta", 0);   # zeros are then purely imaginary or purely real

## --------------------------------------------------------------- poles
puts ("\nvibrations at rest: the motor's terminals short-circuited\n");
gsmbp_modes (m, x0);
held = gsmbp_modes (quiet_, x0, "hold", "theta");
exact = unit * cantilever (p.mp / p.ma, p.jp / (p.ma * p.L ^ 2), 4);
puts ("\nshaft held [rad/s]: four clamped-free modes beside the exact beam with its load\n");
printf ("%12s %12s %12s\n", "four modes", "exact", "error");
printf ("%12.5f %12.5f %12.1e\n", [held.frequency, exact, held.frequency ./ exact - 1]');

## --------------------------------------------------------------- zeros
[A, B, C, D] = quiet_.jac (0, x0, 0);
places = 0:10;
puts ("\nzeros from voltage to a sensor: imaginary parts [rad/s], or pairs of real ones (+-)\n");
printf ("%12s  %s\n", "place", "zeros");
real_ = NaN (11, 3);
imaginary = NaN (11, 3);
for k = places
  s = squares (zeros_of (A, B, C(k+1,:), D(k+1,:)))(1:3);
  printf ("%12.1f  %s\n", k / 10, [cellfun(@in_words, num2cell (s), "UniformOutput", false){:}]);
  s = real (s(imag (s) == 0));
  real_(k+1,1:sum (s > 0)) = sqrt (s(s > 0));
  imaginary(k+1,1:sum (s < 0)) = sqrt (-s(s < 0));
endfor
hub = zeros_of (A, B, C(1,:), D(1,:));
at_hub = sort (abs (hub(imag (hub) > 0)));
printf ("those of the shaft's angle are the frequencies with the shaft held, to %.1e\n", ...
        max (abs (at_hub ./ held.frequency - 1)));
gsmbp_plot ("out/figure_zeros.png", places' / 10, ...
            struct ("y", imaginary, "names", {{"first", "second", "third"}}, "style", ...
                    "linespoints", "label", "imaginary zeros [rad/s]"), ...
            struct ("y", real_(:,1), "names", {{"first"}}, "style", "linespoints", "label", ...
                    "real zeros [rad/s]"), "xlabel", "place of the sensor over the length", ...
            "title", "Zeros from voltage to the place of a sensor", "head", "place");

## --------------------------------------------------------------- a step
t = (0:0.0005:0.5)';
r = gsmbp_simulate (m, x0, t, "input", 6, "rtol", 1e-10);
y = cell2mat (arrayfun (@(k) m.out (t(k), r.x(k,:)', 6), 1:numel (t), "UniformOutput", false))';
puts (["\n6 V at t = 0: least of the arm's places over their distance in the first moments " ...
       "[mrad]\n"]);
printf ("%12s %14s %14s\n", "place", "least", "at [ms]");
for k = [1 4 6 8 11]
  [least, i] = min (y(1:200,k));
  printf ("%12.1f %14.4f %14.1f\n", (k - 1) / 10, 1e3 * least, 1e3 * t(i));
endfor
first = t <= 0.1;
some = [1 6 11];
names = {"shaft", "middle", "tip"};
gsmbp_plot ("out/figure_step.png", t, panel (y(:,some), names, "place/distance [rad]"), ...
            panel (y(:,12), {"moment"}, "moment at the root [N m]"), "title", ...
            "6 V on the motor at t = 0");
gsmbp_plot ("out/figure_first.png", 1e3 * t(first), ...
            panel (1e3 * y(first,some), names, "place/distance [mrad]"), "xlabel", "time [ms]", ...
            "title", "The first moments of the step", "head", "t [ms]");

## --------------------------------------------------------------- what it costs
puts ("\n");
gsmbp_timing (m, 0.1, r.x(201,:), "input", 6);
puts ("\n");
gsmbp_workprecision (m, x0, [0 0.5], "input", 6, "rk4", [2e-3 1e-3 5e-4 2e-4], ...
                     "dp853", 10 .^ -(4:2:12), "file", "out/speed_error.png", "seconds", 0.05);
diary off
