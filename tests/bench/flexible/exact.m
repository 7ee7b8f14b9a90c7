## exact.m OUT: the models of a beam beside a geometrically exact one (exact_beam.m), called by
## `make bench-flexible`; prints tables for flexible.md. Two motions without damping: the spin-up
## of examples/rotating_blade, and the rod of examples/bending_rod, its crank brought from rest to
## a speed within the time of four turns (rod.mac). Three modes each.
##
## The error of a model is the largest deviation of the deflection (tip of the blade, middle of the
## rod) in the whole run, of the largest deflection.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (fileparts (here)));
addpath (here, fullfile (root, "octave"), fullfile (root, "octave", "hand"));
cd (argv (){end});
warning ("off", "all");

## the scene NAME of a file with each of the models
function m = models_of (file, name, stem)
  models = {"second", "full", "linear"};
  for k = 1:3
    own = [stem "_" models{k}];
    text = strrep (fileread (file), ["\"" name "\""], ["\"" own "\""]);
    text = strrep (text, "assumptions = second", ["assumptions = " models{k}]);
    f = fopen ([own ".mac"], "w");
    fputs (f, text);
    fclose (f);
    gsmbp_derive ([own ".mac"], pwd ());
    m{k} = gsmbp_build (own, "directory", pwd ());
  end
end

## the deflection that a model gives at the times t, its first output
function y = deflection (m, x0, t)
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-9, "atol", 1e-10, "start", "project");
  y = cellfun (@(x) m.out (0, x)(1), num2cell (r.x, 2)');
end

## speed, angle, acceleration of a run-up to w within tu
function [a, v, acc] = run_up (w, tu, t)
  a = w * t .^ 2 / (2 * tu) + w * tu / (4 * pi ^ 2) * (cos (2*pi*t/tu) - 1);
  v = w * (t / tu - sin (2*pi*t/tu) / (2*pi));
  acc = w / tu * (1 - cos (2*pi*t/tu));
end

## deflection of the exact blade: 0.02 by 0.02 m of aluminium, hollow (A = 4e-4 m^2, I = 2e-7 m^4)
function y = exact_blade (p, b, t, steps, degree)
  n = degree + 1;
  motion.held = [1, n + 1, 2*n + 1];
  motion.moved = @(t) [p.r, 0, 0; 0, 0, 0; 0, 0, 0];
  motion.u0 = @(s) [p.r + s; 0 * s; 0 * s];
  motion.v0 = @(s) zeros (3*n, 1);
  motion.turning = @(t) [nthargout(2, @run_up, p.w, p.tu, t), nthargout(3, @run_up, p.w, p.tu, t)];
  y = exact_beam (b, motion, t, steps, degree).u(2*n,:);
end

## deflection of the middle of the exact rod, across its chord
function y = exact_rod (p, b, t, steps, degree)
  n = degree + 1;
  motion.held = [1, n + 1, 2*n];
  motion.moved = @(t) pin (p, t);
  motion.turning = @(t) [0, 0];
  motion.u0 = @(s) [p.r + s; 0 * s; 0 * s];
  motion.v0 = @(s) zeros (3*n, 1);
  u = exact_beam (b, motion, t, steps, degree).u;
  k = (n + 1) / 2;
  chord = [u(n,:) - u(1,:); u(2*n,:) - u(n+1,:)];
  middle = [u(k,:) - u(1,:); u(n+k,:) - u(n+1,:)];
  y = (chord(1,:) .* middle(2,:) - chord(2,:) .* middle(1,:)) ./ sqrt (sum (chord .^ 2));
end
function rows_ = pin (p, t)
  [a, v, acc] = run_up (p.w, p.tu, t);
  [c, s] = deal (p.r * cos (a), p.r * sin (a));
  rows_ = [c, -s * v, -c * v^2 - s * acc; s, c * v, -s * v^2 + c * acc; 0, 0, 0];
end

## one row of a table
function row (what, L, m, x0, t, exact, b)
  y = exact (b, t, 1, 6);
  largest = max (abs (y));
  of = @(z) 100 * max (abs (z - y)) / largest;
  for k = 1:3
    off(k) = of (deflection (m{k}, x0, t));
  end
  slender = setfield (setfield (b, "GA", 1000 * b.GA), "rho_I", b.rho_I / 1000);
  printf ("| %s | %.2f | %.3f | %.3f | %s | %.3f | %.5f |\n", what, 100 * largest / L, off(1:2), ...
          {sprintf("%.1f", off(3)), "runs away"}{1 + (off(3) > 1000)}, ...
          of (exact (slender, t, 1, 6)), of (exact (b, t, 2, 8)));
end
function head (what)
  printf (["\n| %s | largest deflection, %% of the length | second, %% off | full | linear " ...
           "| shear, inertia of sections | the exact one's own error |\n" ...
           "|---|---|---|---|---|---|---|\n"], what);
end

puts (["\n# Beams beside a geometrically exact one\n\nReissner's beam (Simo, Vu-Quoc 1986): " ...
       "one polynomial of degree 6 along it, Radau's formula of order 5; its own error: " ...
       "against degree 8 and half the steps. Errors in percent of the largest deflection; the " ...
       "column of shear and inertia of sections is what changes without them.\n"]);
m = models_of (fullfile (root, "examples", "rotating_blade", "rotating_blade_spin_up.mac"), ...
               "rotating_blade_spin_up", "blade");
head ("spin-up, tip of the blade");
for c = [1, 3, 6, 6, 6, 6; 15, 15, 15, 10, 5, 3]
  n = cellfun (@(m) gsmbp_set (m, "w", c(1), "tu", c(2)), m, "UniformOutput", false);
  p = n{1}.par;
  b = struct ("length", p.L, "mass", p.mu, "EI", p.EI, "EA", p.EI * 4e-4 / 2e-7, ...
              "GA", 5/6 / 2.6 * p.EI * 4e-4 / 2e-7, "rho_I", p.mu * 2e-7 / 4e-4, "tip", 0);
  row (sprintf ("%g rad/s in %g s", c), p.L, n, m{1}.initial, linspace (0, c(2), 301), ...
       @(b, t, steps, degree) exact_blade (p, b, t, steps, degree), b);
end
m = models_of (fullfile (here, "rod.mac"), "rod", "rod");
head ("slider-crank, middle of the rod");
for c = [60, 120, 160, 200, 240, 160; 6, 6, 6, 6, 6, 4]
  n = cellfun (@(m) gsmbp_set (m, "w", c(1), "tu", 8*pi / c(1), "d", c(2) / 1000), m, ...
               "UniformOutput", false);
  p = n{1}.par;
  [A, I] = deal (pi * p.d ^ 2 / 4, pi * p.d ^ 4 / 64);
  b = struct ("length", p.l, "mass", p.rho * A, "EI", p.E * I, "EA", p.E * A, ...
              "GA", 0.89 / 2.6 * p.E * A, "rho_I", p.rho * I, "tip", p.ms);
  x0 = zeros (m{1}.sizes.nx, 1);
  x0(3) = p.l + p.r;
  row (sprintf ("%g rad/s, %g mm thick", c), p.l, n, x0, linspace (0, p.tu, 721), ...
       @(b, t, steps, degree) exact_rod (p, b, t, steps, degree), b);
end
