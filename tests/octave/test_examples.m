## The examples (their drivers have run): the tables of the two of the paper against numbers
## computed elsewhere, to all digits that were printed; the scenes of the others against formulas by
## hand.

function test_examples ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  puma ();
  slider_crank ();
  four_bar ();
  andrews ();
  bricard ();
  stewart ();
end

function tab = table (example, file)
  name = fullfile (fileparts (mfilename ("fullpath")), "..", "..", "examples", example, "out", ...
                   file);
  lines = strsplit (strtrim (fileread (name)), "\n");
  values = dlmread (name, ",", 1, 0);
  heads = strtrim (strsplit (strrep (lines{1}, '"', ''), ","));
  for k = 1:numel (heads)
    tab.(heads{k}) = values(:, k);
  end
end

## rows of t, one being wanted at most 1e-9 away
function i = row (tab, t)
  i = find (abs (tab.t - t) < 1e-9);
end

function puma ()
  tab = table ("puma560", "inverse_dynamics.csv");
  wanted = [0,    0,        24.8836, 0.8155,  -0.0257,  1.6509,  0.0956
            0.25, -11.4742, 48.9241, -2.8317, -8.7933,  22.6358, -7.0982
            0.5,  -7.6870,  43.8232, -2.9166, -14.1722, 37.4071, -12.3459
            0.75, 6.8346,   23.2143, -0.5373, -6.7128,  20.9431, -6.8039
            1,    0,        31.9398, 0,       -0.0379,  2.1134,  -0.0053];
  for k = 1:rows (wanted)
    i = row (tab, wanted(k, 1));
    found = [tab.tau1(i), tab.tau2(i), tab.tau3(i), tab.v1(i), tab.v2(i), tab.v3(i)];
    gsmbp_check (sprintf ("PUMA efforts and voltages at t = %g s, four printed decimals", ...
                          wanted(k, 1)), found - wanted(k, 2:end), 0.5001e-4);
  end
  gsmbp_check ("PUMA columns of inverse_dynamics.csv", ...
               isequal (fieldnames (tab)', ...
                        {"t", "q1", "q2", "q3", "tau1", "tau2", "tau3", "v1", "v2", "v3"}));
  gsmbp_check ("PUMA rows at least every 0.01 s", diff (tab.t), 0.01 + 1e-9);
  gsmbp_check ("PUMA tau1(0) = 0", tab.tau1(1), 1e-12);
  gsmbp_check ("PUMA tau2(0), tau3(0) carry the weight", ...
               all (abs ([tab.tau2(1), tab.tau3(1)]) > 0.5));
  related = @(a, b) corr (a, b);
  found = [related(tab.tau1, tab.v1), related(tab.tau2, tab.v2), related(tab.tau3, tab.v3)];
  gsmbp_check ("PUMA voltage is not proportional to effort (correlation)", found, 0.9);

  open = table ("puma560", "open_loop.csv");
  gsmbp_check ("PUMA columns of open_loop.csv", ...
               isequal (fieldnames (open)', {"t", "q1", "q2", "q3", "e1", "e2", "e3"}));
  gsmbp_check ("PUMA open-loop deviation, rad (the paper's figure: 7e-3)", ...
               [open.e1, open.e2, open.e3], 7e-3);
end

function slider_crank ()
  tab = table ("slider_crank", "inverse_dynamics.csv");
  gsmbp_check ("slider-crank columns of inverse_dynamics.csv", ...
               isequal (fieldnames (tab)', {"t", "omega_crank", "omega_rod", "tau", "v"}));
  gsmbp_check ("slider-crank rows at least every 0.01 s", diff (tab.t), 0.01 + 1e-9);
  wanted = [0.5, 3.017812, 3.4535; 1.5, -1.751477, 15.7935; 2.5, 2.222774, 19.4894; 3, ...
            -1.037545, 18.3200; 5, -2.658148, 17.7720];
  for k = 1:rows (wanted)
    i = row (tab, wanted(k, 1))(1);
    gsmbp_check (sprintf ("slider-crank torque at t = %g s, six printed decimals", ...
                          wanted(k, 1)), tab.tau(i) - wanted(k, 2), 0.5001e-6);
    gsmbp_check (sprintf ("slider-crank voltage at t = %g s, four printed decimals", ...
                          wanted(k, 1)), tab.v(i) - wanted(k, 3), 0.5001e-4);
  end
  i = row (tab, 1);   # the acceleration has a kink there: the voltage jumps from 10.4789 to 10.4774
  gsmbp_check ("slider-crank torque at t = 1 s", tab.tau(i) - 2.899184, 0.5001e-6);
  gsmbp_check ("slider-crank voltage before or after the kink at 1 s", ...
               min (abs (tab.v(i) - [10.4789, 10.4774]), [], 2), 0.5001e-4);
  gsmbp_check ("slider-crank crank and rod speed stay in the paper's figure", ...
               [max(tab.omega_crank) / 4, max(abs (tab.omega_rod)) / 1.605], 1 + 1e-9);

  open = table ("slider_crank", "open_loop.csv");
  gsmbp_check ("slider-crank columns of open_loop.csv", ...
               isequal (fieldnames (open)', {"t", "omega_nominal", "omega", "drift"}));
  gsmbp_check ("slider-crank loop stays closed in open loop, m", open.drift, 1e-9);
end

## Hoeken's four-bar: loop and energies by complex numbers, acceleration from J(th) th'' + J'
## th'^2/2 + V' = 0
function four_bar ()
  m = example_model ("four_bar");
  gsmbp_check ("four-bar: mobility 1", m.mobility.true == 1);
  w = 3;
  for th = [0.2 1.5 3 5]
    [q, J] = four_bar_hand (m.par, th);
    x = gsmbp_assemble (m, [q; w; 0; 0], "hold", "theta");
    gsmbp_check (sprintf ("four-bar: angles at crank angle %g, rad", th), ...
                 abs (exp (1i * x(1:3)) - exp (1i * q)), 1e-14);
    energies = @(h) cell2mat (nthargout (2:3, @four_bar_hand, m.par, th + h));
    slope = ne_difference (energies, 1e-3);
    xd = m.rhs (0, x, 0);
    gsmbp_check (sprintf ("four-bar: acceleration at crank angle %g, rad/s^2", th), ...
                 xd(4) + slope * [w^2 / 2; 1] / J, 1e-7);
  end
end

## angles, J = 2 T / (rate of th)^2 and V for crank angles TH (row)
function [q, J, V] = four_bar_hand (p, th)
  B = p.la * exp (1i * th);
  r = p.ld - B;
  rod = arg (r) + acos ((p.lb^2 + abs (r).^2 - p.lc^2) ./ (2 * p.lb * abs (r)));
  arm = p.lb * exp (1i * rod);
  rocker = arg (B + arm - p.ld);
  q = [th; rod - th; rocker];
  wb = p.la * sin (rocker - th) ./ (p.lb * sin (rod - rocker));
  ## twice the energy of a uniform bar by the speeds of its ends
  bar = @(l, va, vb) p.mu * l / 3 * (abs (va).^2 + real (va .* conj (vb)) + abs (vb).^2);
  vB = 1i * B;
  vC = vB + 1i * wb .* arm;
  vP = 2 * vC - vB;
  J = bar (p.la, 0, vB) + bar (2 * p.lb, vB, vP) + bar (p.lc, 0, vC) + p.mp * abs (vP).^2;
  V = p.g ...
      * imag (p.mu * (p.la / 2 * B + 2 * p.lb * (B + arm) + p.lc / 2 * (B + arm)) + p.mp ...
                * (B + 2 * arm));
end

## Andrews' squeezer: published first accelerations, 27 digits at 0.03 s
function andrews ()
  m = example_model ("andrews");
  tab = dlmread (fullfile (fileparts (mfilename ("fullpath")), "..", "data", ...
                           "04_andrews_squeezer", "reference.csv"), ",", 1, 0);
  x0 = gsmbp_assemble (m, tab(1,2:15)', "hold", "beta");
  gsmbp_check ("Andrews: start as published, rad", x0(1:7) - tab(1,2:8)', 1e-15);
  ud = m.acc (0, x0);
  gsmbp_check ("Andrews: first accelerations as published, rad/s^2", ...
               ud(1:2) - [14222.4439199541; -10666.8329399656], 1e-8);
  r = gsmbp_simulate (m, x0, [0 0.03], "rtol", 1e-12, "atol", ...
                      1e-12 * [ones(7, 1); 1e3 * ones(7, 1)]);
  ## a tolerance of 1e-12 on angles of 16 rad, errors grow about a hundredfold
  gsmbp_check ("Andrews: angles at 0.03 s against 27 digits, rad", r.x(end,1:7) - tab(end,2:8), ...
               1e-9);
end

## Bricard's six-bar: sin q1 + sin q2 + sin q1 sin q2 = 0, hinges by rotations, acceleration from
## the one freedom
function bricard ()
  m = example_model ("bricard");
  gsmbp_check ("Bricard: Gruebler 0, true mobility 1", ...
               m.mobility.gruebler == 0 && m.mobility.true == 1);
  w = 1.3;
  for q1 = [0.3 1.2 2.6]
    [P, q] = bricard_hand (q1);
    [~, u] = bricard_hand (q1 + 1e-30i);
    u = w * imag (u) / 1e-30;
    gsmbp_check (sprintf ("Bricard: loop closed at q1 = %g, m", q1), m.con (0, q), 1e-15);
    S = m.ske (0, q);   # two points of the ground, of each rod its two hinges and its middle
    gsmbp_check (sprintf ("Bricard: hinges at q1 = %g, m", q1), S(:,[3:3:15, 16]) - P, 1e-15);
    J = bricard_energy (q1);
    energies = @(h) cell2mat (nthargout (1:2, @bricard_energy, q1 + h));
    slope = ne_difference (energies, 1e-3);
    [xd, info] = m.rhs (0, [q; u]);
    gsmbp_check (sprintf ("Bricard: acceleration at q1 = %g, rad/s^2", q1), ...
                 xd(6) + slope * [w^2 / 2; 1] / J, 1e-8);
    gsmbp_check (sprintf ("Bricard: lost rank told at q1 = %g", q1), info == 2);
  end
end

## hinges (3 x 6) and angles for q1
function [P, q] = bricard_hand (q1)
  q2 = -asin (sin (q1) / (1 + sin (q1)));
  q = [q1; q2; q1; q2; q1];
  rods = [1 0 0; 0 -1 0; 0 0 1; -1 0 0; 0 1 0]';
  R = eye (3);
  P = zeros (3, 6);
  for k = 1:5
    R *= turn_about ([2 3 1 2 3](k), q(k));
    P(:,k+1) = P(:,k) + R * rods(:,k);
  end
end

## rotation by A about the axis number K
function R = turn_about (k, a)
  E = hat (eye (3)(:,k));
  R = eye (3) + sin (a) * E + (1 - cos (a)) * E^2;
end

function E = hat (e)
  E = [0 -e(3) e(2); e(3) 0 -e(1); -e(2) e(1) 0];
end

function [J, V] = bricard_energy (q1)
  v = imag (bricard_hand (q1 + 1e-30i)) / 1e-30;
  [va, vb] = deal (v(:,1:5), v(:,2:6));
  J = sum (sum (va.^2 + va .* vb + vb.^2)) / 3;
  y = bricard_hand (q1)(2,:);
  V = 9.81 * sum (y(1:5) + y(2:6)) / 2;
end

## Stewart platform: strokes of a pose, forces of legs without mass from the platform's balance,
## against the loops and their multipliers
function stewart ()
  m = example_model ("stewart");
  gsmbp_check ("Stewart: mobility 6", m.mobility.true == 6);
  p = m.par;
  at = @(v, k) turn_about (3, 2*pi/3*k) * [v; 0];
  base = [at([p.rb; p.wb], 0), at([p.rb; -p.wb], 0), at([p.rb; p.wb], 1), at([p.rb; -p.wb], 1), ...
          at([p.rb; p.wb], 2), at([p.rb; -p.wb], 2)];
  top = [at([-p.rp; p.wp], 2), at([-p.rp; -p.wp], 1), at([-p.rp; p.wp], 0), ...
         at([-p.rp; -p.wp], 2), at([-p.rp; p.wp], 1), at([-p.rp; -p.wp], 0)];
  light = gsmbp_set (m, "mc", 0, "jc", 0, "mr", 0, "jr", 0, "kc", 0);
  own = zeros (24, 6);
  own(9:3:24,:) = eye (6);
  poses = [0 0 0.8 1 0 0 0; 0.05 -0.08 0.75 0.98 0.1 -0.12 0.05; -0.1 0.04 0.9 0.95 -0.15 0.1 0.2]';
  for k = 1:3
    place = poses(:,k);
    place(4:7) /= norm (place(4:7));
    R = eye (3) + 2 * place(4) * hat (place(5:7)) + 2 * hat (place(5:7))^2;
    D = place(1:3) + R * top - base;
    n = D ./ sqrt (sum (D .^ 2));
    legs = [atan2(-n(2,:), n(3,:)); asin(n(1,:)); sqrt(sum (D .^ 2)) - p.lc - p.lr];
    q = [place; legs(:)];
    gsmbp_check (sprintf ("Stewart, pose %d: inverse kinematics closes the loops, m", k), ...
                 m.con (0, q), 1e-15);
    back = gsmbp_assemble (m, [poses(:,1); legs(:)], "hold", {"s1", "s2", "s3", "s4", "s5", "s6"});
    gsmbp_check (sprintf ("Stewart, pose %d: forward kinematics from the level platform", k), ...
                 back(1:7) - place, 1e-12);
    ## from rest with an acceleration and an angular acceleration (platform axes)
    a = [0.3; -0.7; 1.1];
    al = [2; -1; 3];
    [~, ~, H, gam] = m.con (0, q, zeros (24, 1));
    ud = [a; al; H(:,7:24) \ (gam - H(:,1:6) * [a; al])];
    f = ([own, H'] \ light.inv (0, q, zeros (24, 1), ud, zeros (6, 1)))(1:6);
    c = [0; 0; p.hp];
    pull = p.mp * (a + R * cross (al, c) + [0; 0; p.g]);
    wanted = [n; cross(R * (top - c), n)] \ [pull; R * ([p.jx; p.jx; p.jz] .* al)];
    gsmbp_check (sprintf ("Stewart, pose %d: forces of legs without mass, N", k), f - wanted, ...
                 1e-11);
  end
end
