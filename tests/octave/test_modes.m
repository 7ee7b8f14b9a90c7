## gsmbp_modes: frequencies of data F1_modes_and_cantilever and F2_rotating_beam, closed forms of an
## arm whose shoulder is held and of a bead on a disc that spins, a loop with a crank that is held
## beside the same with a crank that is built in.

function test_modes ()
  cantilever ();
  rotating_beam ();
  held_shoulder ();
  bead_on_a_disc ();
  held_crank ();
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

function refused ()
  m = gsmbp_fixture ("modes_arm");
  for row = {{"hold", "elbow"}, {"spin", "q1"}, {"file", "a.png"}
             "unknown coordinate", "come together", "Campbell"}
    said = gsmbp_complaint (@() gsmbp_modes (m, m.initial, row{1}{:}));
    gsmbp_check (["refused: " row{2}], ! isempty (strfind (said, row{2})));
  end
end
