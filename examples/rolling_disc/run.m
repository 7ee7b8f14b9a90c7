## A thin disc rolls without slipping: circles, the speed at which it stays upright by itself, a
## coin that wobbles; what the plane must hold, and what is conserved; everything goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## state of the disc that touches the plane at the origin and rolls along x: leaning by LEAN
## (rotation about x), turning about z at TURN, leaning further at FALL, rotating about its axis at
## ROLL besides
function x = start (r, lean, turn, fall, roll)
  axis = [0; cos(lean); sin(lean)];
  centre = r * [0; -sin(lean); cos(lean)];
  w = [fall; 0; turn] + roll * axis;
  R = [1, 0, 0; 0, cos(lean), -sin(lean); 0, sin(lean), cos(lean)];
  x = [centre; cos(lean / 2); sin(lean / 2); 0; 0; cross(w, centre); R' * w];
endfunction

function R = turning (e)
  v = e(2:4)(:);
  R = (2 * e(1) ^ 2 - 1) * eye (3) + 2 * (v * v') + 2 * e(1) ...
      * [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
endfunction

## axis of the disc and point of contact (rows) from states (rows)
function [a, c] = seen (r, x)
  for k = 1:rows (x)
    a(k,:) = turning (x(k,4:7))(:,2)';
    down = [0, 0, 1] - a(k,3) * a(k,:);
    c(k,:) = x(k,1:3) - r * down / norm (down);
  endfor
endfunction

## normal force and friction of the contact, and energy (rows)
function [n, f, e] = forces (m, x)
  for k = 1:rows (x)
    [~, lam] = m.acc (0, x(k,:)');
    n(k,1) = lam(1);
    f(k,1) = norm (lam(2:3));
    e(k,1) = sum (m.ene (0, x(k,:)')(1:2));
  endfor
endfunction

pkg load control   # before gsmbp_build: Octave calls a module slowly once its load path has changed

## --------------------------------------------------------------- the models
cpu = gsmbp_derive ("rolling_disc.mac");
cpu2 = gsmbp_derive ("rolling_disc_angles.mac", "out");
printf (["derivation: %.1f s of processor time; in angles %.1f s; Maxima's start " ...
         "included\n"], cpu, cpu2);
m = gsmbp_build ("rolling_disc");
angles = gsmbp_build ("rolling_disc_angles", "directory", "out");
printf (["%d coordinates, %d speeds, %d constraints, of them %d on speeds alone; " ...
         "true mobility %d\n\n"], m.sizes.nq, m.sizes.nu, m.sizes.nlam, numel (m.speed_rows), ...
        m.mobility.true);
p = m.par;
tight = {"rtol", 1e-13, "atol", 1e-13};

## -------------------------------------------------------------- circles
## lean and radius of the centre's circle fix the speed: W^2 = g tan (lean) / (3/2 rho + 1/4 r sin
## (lean)), W: turns about z, rho: radius
puts ("steady circles of the centre: closed form beside ten rounds of the model\n");
printf ("%12s %12s %14s %18s %18s %14s %14s\n", "lean [deg]", "radius [m]", "round in [s]", ...
        "off the circle [m]", "lean changes [rad]", "normal/weight", "friction/normal");
circles = [10, 0.5; 20, 0.3; 45, 0.1; 75, 0];
for k = 1:rows (circles)
  lean = circles(k,1) * pi / 180;
  rho = circles(k,2);
  W = sqrt (p.g * tan (lean) / (1.5 * rho + 0.25 * p.r * sin (lean)));
  x0 = start (p.r, lean, W, 0, -W * rho / p.r - W * sin (lean));
  r = gsmbp_simulate (m, x0, linspace (0, 20 * pi / W, 201), tight{:});
  off = hypot (r.x(:,1) - x0(1), r.x(:,2) - x0(2) + rho) - rho;
  [n, f] = forces (m, r.x(end,:));
  a = seen (p.r, r.x);
  printf ("%12.0f %12.2f %14.6f %18.1e %18.1e %14.6f %14.6f\n", circles(k,:), 2 * pi / W, ...
          max (abs (off)), max (abs (asin (a(:,3)) - lean)), n / (p.m * p.g), f / n);
endfor
puts (["(closed form of the last column: W^2 rho / g; the last row is a coin that " ...
       "wobbles about its own centre)\n\n"]);

## ---------------------------------------- upright: when does it stay so?
critical = sqrt (p.g / (3 * p.r));
printf ("upright rolling: stable above sqrt (g / 3 r) = %.4f rad/s = %.4f m/s\n", critical, ...
        critical * p.r);
printf ("%14s %34s %34s\n", "rate/critical", "of the linear model [1/s]", "closed form [1/s]");
for ratio = [0.5 0.9 0.99 1.01 1.1 2]
  w = ratio * critical;
  x0 = gsmbp_assemble (angles, [0; 0; p.r; 0; 0; 0; w * p.r; 0; 0; 0; 0; w]);
  A = gsmbp_linear (angles, 0, x0).a;
  poles = eig (A);
  [~, k] = max (abs (poles));
  found = poles(k);
  wanted = sqrt (0.8 * (p.g / p.r - 3 * w ^ 2));
  kind = {"grows at", "swings at"}{1 + (w > critical)};
  printf ("%14.2f %20s %13.8f %20s %13.8f\n", ratio, kind, ...
          max (abs ([real(found), imag(found)])), kind, abs (wanted));
endfor
w = 0.9 * critical;
r = gsmbp_simulate (m, start (p.r, 1e-12, 0, 0, w), [0 4 5], tight{:});
a = seen (p.r, r.x);
printf (["the whole model, leaning by 1e-12 at 0.9 of it: grows at %.6f/s (closed " ...
         "form %.6f/s)\n\n"], log (a(3,3) / a(2,3)), sqrt (0.8 * (p.g / p.r - 3 * w ^ 2)));

t = (0:0.005:6)';
ratios = [0.5 0.9 1.1 2];
for k = 1:4
  r = gsmbp_simulate (m, start (p.r, 0.02, 0, 0, ratios(k) * critical), t);
  [a, c] = seen (p.r, r.x);
  leans(:,k) = asin (a(:,3)) * 180 / pi;
  path{k} = c';
endfor
names = arrayfun (@(x) sprintf ("%g of critical", x), ratios, "UniformOutput", false);
gsmbp_plot ("out/figure_lean.png", t, panel (leans, names, "lean [degrees]"), "title", ...
            "A disc pushed by 1.1 degrees, slow and fast");

## --------------------------------------------------------- the coin wobbles
flat = 10 * pi / 180;   # its plane against the floor
W = sqrt (4 * p.g / (p.r * sin (flat)));
x0 = start (p.r, pi / 2 - flat, W, 0, -W * cos (flat));
t2 = linspace (0, 2, 2001)';
r = gsmbp_simulate (m, x0, t2, tight{:});
[~, c] = seen (p.r, r.x);
round = unwrap (atan2 (c(:,2) - x0(2), c(:,1) - x0(1)));
printf (["coin at %.0f degrees: its contact goes round at %.6f rad/s, closed form sqrt (4 g / " ...
         "r sin) = %.6f; the picture on it turns at %.4f rad/s only\n"], flat ...
    * 180 / pi, ...
        (round(end) - round(1)) / 2, W, W * (1 - cos (flat)));
moved = gsmbp_assemble (m, x0 + [zeros(10, 1); 4; 0; 2]);
r = gsmbp_simulate (m, moved, t2, tight{:});
a = seen (p.r, r.x);
[n, f] = forces (m, r.x);
printf (["disturbed: its plane at %.2f to %.2f degrees, normal force %.2f to %.2f of the " ...
         "weight, friction up to %.3f of the normal force\n\n"], min (acos (a(:, ...
          3))) * 180 / pi, ...
        max (acos (a(:,3))) * 180 / pi, min (n) / (p.m * p.g), max (n) / (p.m * p.g), max (f ./ n));
gsmbp_plot ("out/figure_coin.png", t2, panel (acos (a(:,3)) * 180 / pi, {"plane of the coin"}, ...
    "inclination [degrees]"), ...
            panel ([n / (p.m * p.g), f ./ n], {"normal / weight", "friction / normal"}, ...
                   "force ratio [1]"), "title", "A wobbling coin, disturbed");

## ------------------------------------------------------ what is conserved
x0 = start (p.r, 0.5, 1, 0, 8);
t3 = linspace (0, 60, 601)';
printf ("60 s, %s: energy, and the constraints, by the way of solution\n", ...
        "leaning by 0.5 rad at 8 rad/s");
printf ("%-14s %14s %16s %16s %10s %10s\n", "way", "energy [1]", "height [m]", "slip [m/s]", ...
        "calls", "s");
for way = {"baumgarte", "projection", "partitioning", "nullspace", "svd", "kane"}
  r = gsmbp_simulate (m, x0, t3, "loops", way{1});
  [~, ~, e] = forces (m, r.x([1 end],:));
  printf ("%-14s %14.1e %16.1e %16.1e %10d %10.3f\n", way{1}, abs (e(2) / e(1) - 1), ...
          r.stats.drift.phi, r.stats.drift.phidot, r.stats.calls, r.stats.seconds);
endfor
s = gsmbp_timing (m, 0, x0, "print", false);
z = gsmbp_timing (angles, 0, [0; 0; p.r; 0; 0; 0; p.r; 0; 0; 0; 0; 1], "print", false);
printf ("\none call of the right-hand side: %.0f ns; in angles %.0f ns\n", 1e9 * s.rhs, ...
        1e9 * z.rhs);
diary off

## ------------------------------------------------------ what it looks like
styles = {"lines lw 2.4 lc rgb '#00459a'", "lines lw 2 dt (9,5) lc rgb '#cc3318'"};
tracks = [path(1:2)(:), styles(:), names(1:2)(:)];
film ("out/tracks.png", {tracks}, "view", [0, 90], "width", 640, "axis", 0.1);

slow = start (p.r, 0.02, 0, 0, ratios(1) * critical);
r = gsmbp_simulate (m, slow, 0:0.04:3.6);
gsmbp_animate (m, r, "out/motion.gif", "times", r.t, "fps", 25, "trace", "disc", "centres", ...
               false, "title", "Rolling disc", "width", 520);
gsmbp_animate (m, r, "out/skeleton.png", "times", [0, 1.2, 2.4, 3.6], "trace", "disc", ...
               "centres", false, "title", "Rolling disc");
