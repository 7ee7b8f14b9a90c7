## Flexible links: mass matrix, bias and energies of trees against an independent formulation
## (independent/fx_energy.m).

function test_flexible ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  q = [0.7; -0.4; 0.3; 0.5; 0.05; -0.02; 0.04; 0.2; 0.01; 0.03; -0.015];
  qd = [1.3; 0.8; -0.6; 0.9; -0.9; 0.4; 0.5; 1.1; 0.31; -0.7; 0.2];
  compare ("flexible_tree", spatial_tree ("second"), q, qd);
end

function compare (name, tree, q, qd)
  m = gsmbp_fixture (name);
  [M, B, T, V] = fx_terms (tree, q, qd);
  gsmbp_check ([name ": mass matrix, of its largest entry"], ...
               (m.mas (0, q) - M) / max (abs (M(:))), 1e-13);
  ## differences of eighth order with steps of 0.004
  gsmbp_check ([name ": bias, of its largest entry"], (m.bia (0, q, qd, []) - B) / max (abs (B)), ...
               1e-11);
  E = m.ene (0, [q; qd], []);
  gsmbp_check ([name ": energies"], [E(1) / T - 1, E(2) / V - 1], 1e-13);
end

function tree = spatial_tree (model)
  I = [1, 1/10, 1/12; 1/10, 2, 1/11; 1/12, 1/11, 3];
  arm = fx_beam (1.2, 3, diag ([1/5, 1/7, 1/9]), model, {
    "y", "clamped_free", 1, 5, 400 / 1.2 ^ 3 * root(1) ^ 4
    "y", "clamped_free", 2, 6, 400 / 1.2 ^ 3 * root(2) ^ 4
    "z", "clamped_free", 1, 7, 500 / 1.2 ^ 3 * root(1) ^ 4
    "twist", "fixed_free", 1, 8, 70 / 1.2 * (pi / 2) ^ 2
    "stretch", "fixed_free", 1, 9, 9000 / 1.2 * (pi / 2) ^ 2});
  fore = fx_beam (0.7, 1.1 / 0.7, zeros (3), model, {
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

function b = body (parent, at, section, turn, mass, centre, inertia, beam)
  b = struct ("parent", parent, "at", at, "section", section, "turn", {turn}, "mass", mass, ...
              "centre", centre, "inertia", inertia, "beam", beam);
end

## beta of clamped-free shapes
function b = root (i)
  b = fzero (@(b) cos (b) + 1 / cosh (b), (i - 1/2) * pi + [-0.5, 0.5], optimset ("TolX", 0));
end
