## gsmbp_modes: shapes where rigid modes are (of all scenes: test_invariants.m); derivatives that
## are not finite; frequencies of data F1_modes_and_cantilever and F2_rotating_beam, closed forms of
## an arm whose shoulder is held and of a bead on a disc that spins, a loop with a crank that is
## held beside the same with a crank that is built in.

function test_modes ()
  cantilever ();
  rotating_beam ();
  held_shoulder ();
  bead_on_a_disc ();
  held_crank ();
  rigid ();
  free_bus ();
  together ();
  not_finite ();
  output_not_finite ();
  no_equilibrium ();
  refused ();
end

function cantilever ()
  m = gsmbp_fixture ("flexible_tip");
  [~, ref] = gsmbp_case ("F1_modes_and_cantilever");
  for k = 1:numel (ref.tip)
    tip = ref.tip(k);
    if (! strcmp (tip.jn, "0"))
      continue;
    end
    r = gsmbp_modes (gsmbp_set (m, "mu", str2double (tip.mu)), zeros (6, 1));
    gsmbp_check (["cantilever, tip " tip.mu " of its mass: six frequencies"], ...
                 r.frequency ./ str2double (tip.galerkin{6}) - 1, 1e-10);
  end
  r = gsmbp_modes (gsmbp_set (m, "mu", 0, "zeta", 0.03), zeros (6, 1));
  gsmbp_check ("cantilever: damping ratios", r.damping - 0.03, 1e-12);
  gsmbp_check ("cantilever: each shape is its own coordinate", abs (r.shapes) - eye (6), 1e-9);
end

function rotating_beam ()
  m = gsmbp_fixture ("flexible_modes");
  [~, ref] = gsmbp_case ("F2_rotating_beam");
  set = ref.sets(1);
  expected = sort ([str2double(set.flap_model{6}); sqrt(str2double (set.lag_model_squared{6}))]);
  x = zeros (m.sizes.nx, 1);
  r = gsmbp_modes (m, x, "spin", "theta", "speeds", [0, 3, str2double(set.eta)]);
  gsmbp_check ("rotating beam: flap and lag of six modes", ...
               sort (r.frequency(:,3)) ./ expected - 1, 1e-10);
  x(m.sizes.nq + 1) = str2double (set.eta);
  one = gsmbp_modes (m, x, "hold", "theta");
  gsmbp_check ("rotating beam: one speed", one.frequency ./ expected - 1, 1e-10);
end

function held_shoulder ()
  m = gsmbp_fixture ("modes_arm");
  p = m.par;
  x = m.initial;
  x(1:2) = [0.4; -1.2];
  r = gsmbp_modes (m, x, "hold", {"q1", "theta", "s1", "s2"}, "steady", true);
  J = p.J + 1.5 * p.c ^ 2;
  gsmbp_check ("arm, shoulder held: it hangs", r.x(1) + r.x(2) + pi / 2, 1e-12);
  gsmbp_check ("arm, shoulder held: frequency of a pendulum", ...
               r.frequency / sqrt (1.5 * p.g * p.c / J) - 1, 1e-12);
  gsmbp_check ("arm, shoulder held: its damping", ...
               r.damping * 2 * r.frequency * J / p.d - 1, 1e-12);
  gsmbp_check ("arm, shoulder held: its shape", r.shapes' - [0, 1, 0, 0, 0], 1e-12);
end

## seen from the disc a bead between equal springs whirls at w0 - W and w0 + W
function bead_on_a_disc ()
  m = gsmbp_fixture ("modes_arm");
  w0 = sqrt (m.par.k / m.par.m);
  speeds = [0.01, 5, 10, 15];
  file = [tempname() ".png"];
  r = gsmbp_modes (m, m.initial, "hold", {"q1", "q2"}, "spin", "theta", "speeds", speeds, ...
                   "file", file);
  gsmbp_check ("bead on a disc: it whirls", ...
               sort (r.frequency) ./ [w0 - speeds; w0 + speeds] - 1, 1e-11);
  drawn = exist (file, "file") && exist (strrep (file, ".png", ".csv"), "file");
  gsmbp_check ("bead on a disc: the diagram is drawn", drawn);
  text = evalc ("gsmbp_modes (m, m.initial, \"hold\", {\"q1\", \"q2\", \"theta\"})");
  gsmbp_check ("modes are printed", ! isempty (strfind (text, "2 modes")));
end

## efforts of gravity hold the crank, multipliers the loop: both change with the coordinates
function held_crank ()
  m = gsmbp_fixture ("flexible_slider_crank");
  f = gsmbp_fixture ("flexible_held");
  a = f.par.a;
  x = gsmbp_assemble (m, [a; -a; 0.5; 0; 0], "hold", "q1");
  y = gsmbp_assemble (f, [0; 0.5; 0; 0]);
  r = gsmbp_modes (m, x, "hold", "q1", "steady", true);
  s = gsmbp_modes (f, y, "steady", true);
  gsmbp_check ("crank held: the rod sags as with a crank built in", ...
               [r.x(3:5) - s.x(2:4); r.x(1) + r.x(2) - s.x(1)], 1e-12);
  gsmbp_check ("crank held: sag", abs (r.x(4)) > 1e-4);
  gsmbp_check ("crank held: frequencies as with a crank built in", ...
               r.frequency ./ s.frequency - 1, 1e-10);
  gsmbp_check ("crank held: nothing else is left", ...
               [numel(r.real), r.rigid, numel(r.frequency) - 2], 0);
end

## the momentum along a rigid mode stays; of the motors the rows of Kirchhoff and Newton
function rigid ()
  m = gsmbp_fixture ("modes_rigid");
  p = m.par;
  r = gsmbp_modes (m, m.initial);
  shape = @(name) r.shapes(:,abs (r.shapes(strcmp (m.coordinates, name),:)) == 1);
  of = @(s, name) s(strcmp (m.coordinates, name),:);
  gsmbp_check ("two free discs: shape", of (shape ("psi"), "phi") + p.J2 / (p.J1 + p.J2), 1e-12);
  gsmbp_check ("cart and pendulum: shape", ...
               of (shape ("theta"), "s") + p.mb * p.l / (p.mc + p.mb), 1e-12);
  gsmbp_check ("motor with one disc: shape", ...
               shape ("gamma")' - strcmp (m.coordinates, "gamma")', 1e-12);
  e = r.eigenvalues(abs (of (r.shapes, "alpha")) > 0).';
  [alpha, beta] = deal (of (r.shapes, "alpha"), of (r.shapes, "beta"));
  [alpha, beta] = deal (alpha(alpha != 0), beta(alpha != 0));
  i = -0.5 * e .* alpha ./ (0.05 * e + 0.5);
  gsmbp_check ("motor with two discs: both modes are there", numel (e) - 2, 0);
  gsmbp_check ("motor with two discs: second disc", ...
               p.J2 * e .^ 2 .* (alpha + beta) ./ (p.k * beta) + 1, 1e-9);
  gsmbp_check ("motor with two discs: first disc", ...
               (p.J1 * e .^ 2 .* alpha - p.k * beta) ./ (0.5 * i) - 1, 1e-9);
end

## Euler parameters about the unit: half the angle
function free_bus ()
  m = gsmbp_fixture ("modes_free");
  r = gsmbp_modes (m, m.initial);
  bus = -m.par.Jp / (m.par.Jb + m.par.Jp);
  gsmbp_check ("free bus with a panel: shape", r.shapes' - [0 0 0 0 0 0 bus/2 1], 1e-12);
  gsmbp_check ("free bus with a panel: rigid modes", r.rigid - 12, 0);
end

## springs without rest whose points coincide are linear: no length, no direction
function together ()
  m = gsmbp_fixture ("modes_together");
  A = [-150 100; 50 -50];
  gsmbp_check ("springs of length 0: A", m.jac (0, zeros (6, 1))(4:6,1:3) - blkdiag (A, -80), ...
               1e-12);
  gsmbp_check ("springs of length 0: frequencies", ...
               gsmbp_modes (m, zeros (6, 1)).frequency - ...
               sort ([sqrt(-eig (A)); sqrt(80)]), 1e-9);
  [P, A] = m.rhp (0, zeros (6, 1));
  gsmbp_check ("springs of length 0: by parameters and backwards", ...
               [P; m.adj(0, zeros (6, 1), [], (1:6)') - A' * (1:6)'], 1e-12);
  x = [0.3; -0.2; 0.7; 0; 0; 0];
  E = m.ene (0, x);
  gsmbp_check ("springs without rest: energy", ...
               E(2) - (100 * 0.5 ^ 2 + 50 * 0.3 ^ 2 + 40 * 2 * 0.3 ^ 2 * (1 - cos (0.7))) / 2, ...
               1e-12);
  r = gsmbp_simulate (m, x, [0 1], "method", "radau", "audit", 1);
  gsmbp_check ("springs without rest: energy balance", r.audit.error, 1e-6);
end

## what needs a derivative that is not finite names it
function not_finite ()
  pkg load control
  m = gsmbp_fixture ("modes_apart");
  plan = gsmbp_plan ("quintic", zeros (3, 2), [0 1]);
  for row = {[0; 0; 1; 0; 0; 0], [0; 0.2; 0; 0; 0; 0]; "x1_d by x1", "x3_d by x3"}
    x = row{1};
    asked = {@() gsmbp_modes(m, x), @() gsmbp_linear(m, 0, x), @() gsmbp_mck(m, 0, x), ...
             @() gsmbp_trim(m, x), ...
             @() gsmbp_control(m, struct ("x", x, "v", 0), "lqr"), ...
             @() gsmbp_simulate(m, x, [0 1], "method", "radau"), ...
             @() gsmbp_simulate(m, x, [0 1], "method", "cvode")};
    for ask = asked(1:end - 2 * (row{2}(2) == "1"))   # the rate itself is not finite
      said = gsmbp_complaint (ask{1});
      gsmbp_check (["a derivative is not finite: " said], ...
                   ! isempty (strfind (said, [row{2} " is not finite"])));
    end
  end
end

## of an output it is a warning of the linear model, an error of a controller that measures it
function output_not_finite ()
  m = gsmbp_fixture ("modes_apart");
  e = struct ("x", [0; 0.2; 1; 0; 0; 0], "v", 0);
  said = {evalc("gsmbp_linear (m, 0, e.x);"), gsmbp_complaint(@() gsmbp_control (m, e, "lqr"))};
  said = regexprep (said, '\s+', " ");
  gsmbp_check (["an output without derivative: " said{2}], ...
               ! cellfun (@isempty, strfind (said, "of the output place by x1 is not finite")));
end

## a pendulum that is let go from the side: a warning; one that hangs: none
function no_equilibrium ()
  m = gsmbp_fixture ("modes_rigid");
  x = m.initial;
  x(strcmp (m.states, "theta")) = 1;
  said = {evalc("gsmbp_modes (m, x)"), evalc("gsmbp_modes (m, m.initial)")};
  doubted = strfind (said, "found theta_d with an acceleration of -");
  gsmbp_check ("a warning where there is no equilibrium", [1, 0] == cellfun (@numel, doubted));
end

function refused ()
  m = gsmbp_fixture ("modes_arm");
  for row = {{"hold", "elbow"}, {"spin", "q1"}, {"file", "a.png"}
             "unknown coordinate", "come together", "Campbell"}
    said = gsmbp_complaint (@() gsmbp_modes (m, m.initial, row{1}{:}));
    gsmbp_check (["refused: " row{2}], ! isempty (strfind (said, row{2})));
  end
end
