## Flexible links: the two-link arm of data F4_two_link_arm; mass matrix, bias and energies of
## spatial trees against an independent formulation (independent/fx_energy.m); a closed loop with a
## rod that bends.

function test_flexible ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  two_link_arm ();
  q = [0.7; -0.4; 0.3; 0.5; 0.05; -0.02; 0.04; 0.2; 0.01; 0.03; -0.015];
  qd = [1.3; 0.8; -0.6; 0.9; -0.9; 0.4; 0.5; 1.1; 0.31; -0.7; 0.2];
  compare ("flexible_tree", spatial_tree (), q, qd);
  for model = {"full", "linear"}
    compare (["flexible_" model{1}], one_beam (model{1}), ...
             [0.7; -0.4; 0.12; -0.09; 0.02], [1.3; 0.8; -0.9; 0.7; 0.31]);
  end
  compare ("flexible_data", by_data (), [0.7; -0.4; 0.3; 0.12; -0.03], ...
           [1.3; 0.8; -0.6; 0.7; 0.31]);
  rod_in_a_loop ();
  held_at_its_tip ();
  section_loads ();
  points_of_pictures ();
end

## four states: M, N + G + elastic and damping efforts, inverse and forward dynamics, payload
function two_link_arm ()
  folder = fullfile (fileparts (mfilename ("fullpath")), "..", "data", "F4_two_link_arm");
  ref = jsondecode (fileread (fullfile (folder, "reference.json")));
  spec = jsondecode (fileread (fullfile (folder, "spec.json")));
  for model = {"second", "full", "linear"}
    m = gsmbp_fixture (["case_f4_" model{1}]);
    worst = zeros (1, 5);
    for k = 1:numel (spec.states)
      r = ref.models.(model{1})(k);
      [x, xd, xdd] = deal (str2double (spec.states(k).x), str2double (spec.states(k).xd), ...
                           str2double (spec.states(k).xdd));
      M = reshape (str2double (vertcat (r.M{:})), 6, 6);
      bias = str2double (r.c) + str2double (r.G) + str2double (r.Kq) + str2double (r.Dqd);
      worst = max (worst, [ ...
        apart(m.mas (0, x), M), apart(m.bia (0, x, xd, []), bias), ...
        apart(m.inv (0, x, xd, xdd, []), str2double (r.tau)), ...
        apart(m.fwd (0, x, xd, [], zeros (6, 1)), str2double (r.xdd_free)), ...
        apart(m.out (0, [x; xd], [])(1:2), str2double (r.tip)(1:2))]);
    end
    ## of the largest entry; accelerations solve a system of condition 1e4
    gsmbp_check (["two-link arm, " model{1} ": M, bias, efforts, payload"], worst([1:3, 5]), 1e-14);
    gsmbp_check (["two-link arm, " model{1} ": accelerations"], worst(4), 1e-12);
  end
end
function d = apart (a, b)
  d = max (abs (a(:) - b(:))) / max (abs (b(:)));
end

function compare (name, tree, q, qd)
  m = gsmbp_fixture (name);
  [M, B, T, V] = fx_terms (tree, q, qd);
  gsmbp_check ([name ": mass matrix, of its largest entry"], ...
               (m.mas (0, q) - M) / max (abs (M(:))), 1e-13);
  ## differences of eighth order with steps of 0.004
  gsmbp_check ([name ": bias, of its largest entry"], ...
               (m.bia (0, q, qd, []) - B) / max (abs (B)), 1e-11);
  [~, B, C] = m.lin (0, q, qd, flip (qd), []);
  [dB, dC] = slopes (m, q, qd, flip (qd));
  gsmbp_check ([name ": linear model, of its largest entries"], ...
               [(B - dB) / max(abs (B(:))), (C - dC) / max(abs (C(:)))], 1e-8);
  E = m.ene (0, [q; qd], []);
  gsmbp_check ([name ": energies"], [E(1) / T - 1, E(2) / V - 1], 1e-13);
end

## derivatives of the efforts by speeds and coordinates, by differences of fourth order
function [dB, dC] = slopes (m, q, u, ud)
  n = numel (q);
  h = 1e-3;
  for k = 1:n
    e = zeros (n, 1);
    e(k) = h;
    f = @(a, b) m.inv (0, q + a * e, u + b * e, ud, []);
    dB(:, k) = (8 * (f (0, 1) - f (0, -1)) - f (0, 2) + f (0, -2)) / (12 * h);
    dC(:, k) = (8 * (f (1, 0) - f (-1, 0)) - f (2, 0) + f (-2, 0)) / (12 * h);
  end
end

function tree = spatial_tree ()
  model = "second";
  I = [1, 1/10, 1/12; 1/10, 2, 1/11; 1/12, 1/11, 3];
  arm = fx_beam (1.2, 3, @(xi) [(1 - xi / 3) / 5; xi * 0 + 1/7; (1 + xi) / 9], model, {
    "y", "clamped_free", 1, 5, 400 / 1.2 ^ 3 * root(1) ^ 4
    "y", "clamped_free", 2, 6, 400 / 1.2 ^ 3 * root(2) ^ 4
    "z", "clamped_free", 1, 7, 500 / 1.2 ^ 3 * root(1) ^ 4
    "twist", "fixed_free", 1, 8, 70 / 1.2 * (pi / 2) ^ 2
    "stretch", "fixed_free", 1, 9, 9000 / 1.2 * (pi / 2) ^ 2});
  fore = fx_beam (0.7, @(xi) 1.6 * (1 - xi / 2) + exp (-2 * xi), [0; 0; 0], model, {
    "z", "pinned_pinned", 1, 10, 90 / 0.7 ^ 3 * pi ^ 4
    "z", "pinned_pinned", 2, 11, 90 / 0.7 ^ 3 * (2 * pi) ^ 4});
  [z, no] = deal ([0; 0; 0], zeros (3));
  tree.gravity = [1; -9; 2];
  tree.bodies = [
    body(0, z, [], {[0; 0; 1], 1}, 2, [0.1; 0.2; -0.1], diag ([0.3, 0.4, 0.5]), [])
    body(1, [0.3; 0; 0.1], [], {[0; 1; 0], 2}, 0, z, no, arm)
    body(2, [0; 0.05; -0.02], fx_sections(arm, 1/2), {[1; 0; 0], 3}, 1.5, [0.2; 0.1; 0.3], ...
         diag ([0.1, 0.2, 0.15]), [])
    body(2, [0; 0; 0.1], fx_sections(arm, 1), {[1; 0; 1], 4}, 0, z, no, fore)
    body(4, z, fx_sections(fore, 1), {}, 2.5, [1/3; 1/4; -1/5], I, [])];
end

## one beam that bends both ways and stretches, with a rigid body at its end
function tree = one_beam (model)
  ## the one of the model full is tapered
  rho = merge (strcmp (model, "full"), {@(xi) 3 * (1 - xi / 2) .^ 2}, {3}){1};
  EI = 400 * merge (strcmp (model, "full"), 1/3, 1);
  arm = fx_beam (1.2, rho, [0; 0; 0], model, {
    "y", @(xi) deal (xi .^ 2, 2 * xi), 0, 3, EI / 1.2 ^ 3 * 4
    "z", @(xi) deal (xi .^ 2, 2 * xi), 0, 4, 500 / 1.2 ^ 3 * 4
    "stretch", "fixed_free", 1, 5, 9000 / 1.2 * (pi / 2) ^ 2});
  z = [0; 0; 0];
  tree.gravity = [1; -9; 2];
  tree.bodies = [
    body(0, z, [], {[0; 0; 1], 1}, 2, [0.1; 0.2; -0.1], diag ([0.3, 0.4, 0.5]), [])
    body(1, [0.3; 0; 0.1], [], {[0; 1; 0], 2}, 0, z, zeros (3), arm)
    body(2, z, fx_sections(arm, 1), {}, 2.5, [1/3; 1/4; -1/5], diag ([1, 2, 3]), [])];
end

## the beam of share/flexible/cantilever.txt with a body at its end and one half way along
function tree = by_data ()
  rod = fx_beam (0.8, 1.5 / 0.8, [0; 0; 0], "second", {
    "y", "clamped_free", 1, 4, 30 / 0.8 ^ 3 * root(1) ^ 4
    "y", "clamped_free", 2, 5, 30 / 0.8 ^ 3 * root(2) ^ 4});
  z = [0; 0; 0];
  tree.gravity = [1; -9; 2];
  tree.bodies = [
    body(0, z, [], {[0; 0; 1], 1}, 2, [0.1; 0.2; -0.1], diag ([0.3, 0.4, 0.5]), [])
    body(1, [0.3; 0; 0.1], [], {[0; 1; 0], 2}, 0, z, zeros (3), rod)
    body(2, z, fx_sections(rod, 1), {}, 2.5, [1/3; 1/4; -1/5], diag ([1, 2, 2.5]), [])
    body(2, z, fx_sections(rod, 1/2), {[1; 0; 0], 3}, 1.5, [0.2; 0.1; 0.3], ...
         diag ([0.1, 0.2, 0.15]), [])];
end

function b = body (parent, at, section, turn, mass, centre, inertia, beam)
  b = struct ("parent", parent, "at", at, "section", section, "turn", {turn}, "mass", mass, ...
              "centre", centre, "inertia", inertia, "beam", beam);
end

## beta of clamped-free shapes
function b = root (i)
  b = fzero (@(b) cos (b) + 1 / cosh (b), (i - 1/2) * pi + [-0.5, 0.5], optimset ("TolX", 0));
end

## A slider-crank with a rod that bends: the loop stays closed at the bent end, and energy is kept.
function rod_in_a_loop ()
  m = gsmbp_fixture ("flexible_slider_crank");
  x0 = m.initial;
  x0(m.sizes.nq + 1) = 20;
  t = linspace (0, 0.4, 81);
  run = gsmbp_simulate (m, x0, t, "start", "project", "rtol", 1e-11);
  for k = 1:numel (t)
    E = m.ene (t(k), run.x(k, :)', []);
    energy(k) = E(1) + E(2);
  end
  gsmbp_check ("slider-crank with a rod that bends: energy over a turn", ...
               (energy - energy(1)) / max (abs (energy)), 1e-9);
  gsmbp_check ("slider-crank with a rod that bends: the loop at the bent end", ...
               run.stats.drift.phi, 1e-9);
  gsmbp_check ("slider-crank with a rod that bends: it bends", max (abs (run.x(:, 4))) > 1e-4);
end

## A tree that comes to a beam at its tip: energies and modal accelerations are those of the tree
## that comes to its root.
function held_at_its_tip ()
  A = gsmbp_fixture ("flexible_at_root");
  B = gsmbp_fixture ("flexible_at_tip");
  [q, u] = deal ([0.3; -0.2; 0.7; 0.02; -0.01], [1; 0.5; -0.8; 0.6; 0.3]);
  y = A.out (0, [q; u], []);
  x = [y(1:2); atan2(y(9), y(8)); q(4:5); y(4:5); y(7); u(4:5)];
  [a, b] = deal (A.rhs (0, [q; u], []), B.rhs (0, x, []));
  gsmbp_check ("turn of a section: sine of its half", ...
               [y(end) - sin(x(3) / 2), B.out(0, x, [])(end) - y(end)], 1e-14);
  E = A.ene (0, [q; u], []) - B.ene (0, x, []);
  gsmbp_check ("a beam held at its tip: energies", E, 1e-13);
  ## the mass matrix has the condition 1e5
  gsmbp_check ("a beam held at its tip: modal accelerations", b(9:10) ./ a(9:10) - 1, 1e-9);
end

## Loads of a section in equilibrium: of bending those of statics, since the shapes hold the exact
## deflection; of torsion and stretch the sums of two sines.
function section_loads ()
  m = gsmbp_fixture ("flexible_loads");
  v = 1e-4 * [4; 3; -2; 5];
  r = gsmbp_trim (m, zeros (m.sizes.nx, 1), v);
  y = m.out (0, r.x, v);
  k = ([1, 2] - 1/2) * pi;
  part = sum (2 * sin (k) .* cos (k / 4) ./ k);
  [N, Mz, My] = deal (part * v(1), 0.6 * v(2), -0.6 * v(3));
  expected = [part * v(4); My; Mz; N; v(2:3)];
  ## loads act on the bent beam: by some F L^2/(E I), 1e-6
  gsmbp_check ("loads of a section: torsion, bending, normal force, shear", ...
               (y(1:6) - expected) ./ expected, 1e-5);
  strain_ = N / 2e5 - 0.01 * Mz / 400 - 0.02 * My / 500;
  gsmbp_check ("loads of a section: strain of a fibre", y(7) / strain_ - 1, 1e-5);
end

## In pictures the rod goes through its sections where it is bent to.
function points_of_pictures ()
  m = gsmbp_fixture ("flexible_slider_crank");
  x = gsmbp_assemble (m, [0.8; -1; 0.5; 0.02; 0.005], "hold", {"q1", "rod_1", "rod_2"});
  P = m.ske (0, x(1:5));
  rod = sum (m.skeleton.points(1:2)) + (1:m.skeleton.joints(3));
  c = x(1) + x(2);
  across = [-sin(c), cos(c), 0] * (P(:,rod) - P(:,rod(1)));
  ## tip and middle: shapes sqrt(2) sin(i pi xi)
  gsmbp_check ("points of a picture: the rod bends", across - [0, 0, sqrt(2) * 0.02], 1e-14);
end
