## F = fx_slider_crank (PAR): the slider-crank of tests/scenes/flexible_slider_crank.mac, written
## without GSMBP: Lagrange's equations in z, the angle of the crank and the amplitudes of the rod's
## shapes sqrt(2) sin(i pi s/l2), i = 1, 2; the loop is solved for the angle of the rod's chord.
## PAR: g, l1, l2, m1, m2, m3, EI.
##   accelerations (Z, ZD)
##   efforts (Z, ZD, ZDD)   by z, that the motion needs
##   state (Z, ZD)   [crank, chord from the crank, slider, amplitudes] and their rates
##   rigid (A, AD)   acceleration of the crank where the rod stays straight
##
## The kinetic energy of the rod is that of its field [s - q'H q/2; phi q], cut at degree 2 in q and
## its rates; integrals are sums over 30 Gauss points, derivatives complex steps.

function f = fx_slider_crank (p)
  p.rod = rod (p);
  f.accelerations = @(z, zd) accelerations (p, z, zd);
  f.efforts = @(z, zd, zdd) efforts (p, z, zd, zdd);
  f.state = @(z, zd) state (p, z, zd);
  f.rigid = @(a, ad) rigid (p, a, ad);
end

## integrals over the mass, s the place on the axis, H = int_0^s phi' phi' ds: of phi, s phi,
## phi phi', H, s H; H of the end; the stiffness
function r = rod (p)
  [x, w] = fx_gauss (30);
  s = p.l2 * x';
  phi = sqrt (2) * [sin(pi * x'), sin(2 * pi * x')];
  for k = 1:numel (x)
    H(k,:) = products (p.l2, x(k), x, w);
  end
  square = @(h) h([1, 2; 2, 3]);
  over = @(f) p.m2 * w * f;
  r.phi = over (phi);
  r.s_phi = over (s .* phi);
  r.phi_phi = p.m2 * phi' * (w' .* phi);
  r.H = square (over (H));
  r.s_H = square (over (s .* H));
  r.H_end = square (products (p.l2, 1, x, w));
  curvature = -phi .* ([1, 2] * pi / p.l2) .^ 2;
  r.stiffness = p.EI * p.l2 * w * curvature .^ 2;
end
function h = products (l, up, x, w)
  slope = @(i) sqrt (2) * i * pi / l * cos (i * pi * up * x);
  h = l * up * [w * (slope(1) .^ 2)', w * (slope(1) .* slope(2))', w * (slope(2) .^ 2)'];
end

## length e of the chord and its gradient by q; angle c of the chord and its gradient by z
function [e, eq, c, cz] = chord (p, z)
  eq = -z(2:end).' * p.rod.H_end;
  e = p.l2 + eq * z(2:end) / 2;
  c = -asin (p.l1 * sin (z(1)) / e);
  cz = [-p.l1 * cos(z(1)), -sin(c) * eq] / (e * cos (c));
end

## M of the kinetic energy zd' M zd/2, and the potential energy
function [M, V] = energies (p, z)
  [e, eq, c, cz] = chord (p, z);
  q = z(2:3);
  row = slider (p, z, e, eq, c, cz);
  M = p.m3 * (row.' * row);
  M(1,1) += p.m1 * p.l1 ^ 2 / 3;
  ## of the rod's frame in its own axes: velocity and turn; rates of the amplitudes
  b = c - z(1);
  J = [p.l1 * sin(b), 0, 0; p.l1 * cos(b), 0, 0; cz; 0, 1, 0; 0, 0, 1];
  M += J.' * of_rod (p, q) * J;
  along = p.m2 * p.l2 / 2 - q.' * p.rod.H * q / 2;
  V = p.g * (p.m2 * p.l1 * sin (z(1)) + along * sin (c) + p.rod.phi * q * cos (c));
  V += p.m1 * p.g * p.l1 / 2 * sin (z(1)) + p.rod.stiffness * q .^ 2 / 2;
end
function row = slider (p, z, e, eq, c, cz)
  row = -e * sin (c) * cz + [-p.l1 * sin(z(1)), cos(c) * eq];
end

## mass matrix of the rod by velocity and turn of its frame and the rates of the amplitudes, without
## what is above degree 2 in q and its rates
function M = of_rod (p, q)
  r = p.rod;
  across = r.phi * q;
  along = p.m2 * p.l2 / 2 - q.' * r.H * q / 2;
  turned = p.m2 * p.l2 ^ 2 / 3 - q.' * r.s_H * q + q.' * r.phi_phi * q;
  B = [-q.' * r.H; r.phi; r.s_phi];
  M = [p.m2, 0, -across; 0, p.m2, along; -across, along, turned];
  M = [M, B; B.', r.phi_phi];
end

function zdd = accelerations (p, z, zd)
  [M, force] = motion (p, z, zd);
  zdd = M \ force;
end
## M zdd = force where nothing drives
function [M, force] = motion (p, z, zd)
  h = 1e-30;
  force = zeros (3, 1);
  for k = 1:3
    [M, V] = energies (p, z + 1i * h * ((1:3)' == k));
    pull = imag (M) / h * zd;
    force(k) += zd' * pull / 2 - imag (V) / h;
    force -= pull * zd(k);
  end
  M = real (M);
end
function e = efforts (p, z, zd, zdd)
  [M, force] = motion (p, z, zd);
  e = M * zdd - force;
end

## of the rigid mechanism: the amplitudes stay 0
function add = rigid (p, a, ad)
  h = 1e-30;
  M = energies (p, [a; 0; 0])(1);
  [dM, dV] = energies (p, [a + 1i * h; 0; 0]);
  add = -imag (dM(1) * ad ^ 2 / 2 + dV) / h / M;
end

function x = state (p, z, zd)
  [e, eq, c, cz] = chord (p, z);
  slide = p.l1 * cos (z(1)) + e * cos (c);
  x = [z(1); c - z(1); slide; z(2:3)];
  x = [x; zd(1); cz * zd - zd(1); slider(p, z, e, eq, c, cz) * zd; zd(2:3)];
end
