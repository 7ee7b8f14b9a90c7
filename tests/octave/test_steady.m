## Steady motions: a disc that rolls straight on and in a circle, a heavy top's precession, a motor
## at speed, a driven shaft, each against its closed form; ignorable coordinates dropped; M, C and K
## about them.

function test_steady ()
  pkg load control
  straight ();
  circle ();
  top ();
  motor ();
  second_order ();
  driven ();
  all_driven ();
  refused ();
end

function k = at (m, name)
  k = find (strcmp (m.states, name));
end

## every coordinate driven: the motion is steady, nothing is left when it is dropped
function all_driven ()
  m = gsmbp_fixture ("steady_turn");
  r = gsmbp_trim (m, [0; 10], [], "steady", "q");
  gsmbp_check ("all driven: the state of the motion", r.x(:) - [0; 10], 1e-12);
  sys = gsmbp_linear (m, 0, [0; 10], [], "drop", "running");
  gsmbp_check ("all driven: no state is left", isempty (sys.a));
end

## A disc upright at the spin w: the lean l obeys (A + m R^2) l'' = (m g R - C (C + m R^2) w^2/A) l,
## it falls below w^2 = g/(3 R)
function straight ()
  m = gsmbp_fixture ("steady_disc");
  [M, R, g] = deal (m.par.m, m.par.R, m.par.g);
  [A, C] = deal (M * R ^ 2 / 4, M * R ^ 2 / 2);
  critical = sqrt (g / (3 * R));
  for w = [0.5, 0.999, 1.001, 3] * critical
    x = m.initial;
    x(at (m, "spin_d")) = w;
    r = gsmbp_trim (m, x, [], "steady", "spin");
    [sys, T, k, gone] = gsmbp_linear (m, 0, r.x, [], "drop", {"x", "y", "yaw", "spin"});
    rate = sort (real (pole (sys) .^ 2));
    gsmbp_check (sprintf ("disc, straight on at %.3f of the critical speed", w / critical), ...
                 extreme (rate) - ...
                 (M * g * R - C * (C + M * R ^ 2) * w ^ 2 / A) / (A + M * R ^ 2), 1e-9 * w ^ 2);
  end
  gsmbp_check ("disc, straight on: what is dropped", ...
               isequal (gone, {"x", "y", "yaw", "spin"}) && isequal (k, [5, 10:12]));
  gsmbp_check ("disc, straight on: its centre moves at R w", r.x(at (m, "x_d")) - R * w, 1e-12);
  gsmbp_check ("disc, straight on: what runs", isequal (r.running, {"x", "spin"}));
end
function r = extreme (rate)
  [~, k] = max (abs (rate));
  r = rate(k);
end

## in a circle: with the axis k at th from the vertical, w2 = ph sin(th) up in the disc, w3 about k,
## A w2^2 cot(th) - (C + m R^2) w2 w3 - m g R cos(th) = 0
function circle ()
  m = gsmbp_fixture ("steady_disc");
  [M, R, g] = deal (m.par.m, m.par.R, m.par.g);
  [A, C] = deal (M * R ^ 2 / 4, M * R ^ 2 / 2);
  for rates = [3, 3, 1; 6, 12, -9]
    x = m.initial;
    x(at (m, "yaw")) = 0.7;
    x(at (m, "lean")) = -0.2 * sign (prod (rates));
    x([at(m, "yaw_d"), at(m, "spin_d")]) = rates;
    r = gsmbp_trim (m, x, [], "steady", {"yaw", "spin"});
    lean = r.x(at (m, "lean"));
    [th, ph] = deal (pi / 2 + lean, rates(1));
    w2 = ph * sin (th);
    w3 = -(rates(2) - ph * cos (th));
    what = sprintf ("disc, turning at %g with spin %g", rates);
    gsmbp_check ([what ": balance of moments [N m]"], ...
                 A * w2 ^ 2 * cot (th) - (C + M * R ^ 2) * w2 * w3 - M * g * R * cos (th), 1e-11);
    [sys, ~, k, gone] = gsmbp_linear (m, 0, r.x, [], "drop", "running");
    gsmbp_check ([what ": four states are left"], ...
                 isequal (m.states(k)', {"lean", "yaw_d", "lean_d", "spin_d"}));
    y = gsmbp_simulate (m, r.x, [0, 2]);
    gsmbp_check ([what ": it goes on so"], y.x(end,[5, 10, 12]) - r.x([5, 10, 12])', 1e-9);
  end
end

## precession p of a top whose nutation is given: A p^2 cos(th) - C w3 p + m g l = 0
function top ()
  m = gsmbp_fixture ("steady_top");
  p = m.par;
  [A, C, W] = deal (p.i1 + p.m * p.l ^ 2, p.i3, p.m * p.g * p.l);
  [th, spin] = deal (0.4, 300);
  for guess = [2, 40]
    x = m.initial;
    x(at (m, "psi_d")) = guess;
    x(at (m, "phi_d")) = spin;
    r = gsmbp_trim (m, x, [], "steady", {"psi", "phi"}, "hold", "theta", "free", "psi_d");
    rate = r.x(at (m, "psi_d"));
    roots_ = roots ([(A - C) * cos(th), -C * spin, W]);
    gsmbp_check (sprintf ("top: precession near %g", guess), min (abs (rate ./ roots_ - 1)), 1e-12);
  end
  k = gsmbp_mck (m, 0, r.x, [], "drop", {"psi", "phi"});
  gsmbp_check ("top: no damping, skew gyroscopic terms", ...
               [k.D(:) / max(abs (k.G(:))); k.G(:) + k.G'(:)], 1e-12);
  gsmbp_check ("top: mass matrix", k.M - m.mas (0, r.x(1:3)), 1e-15);
  said = gsmbp_complaint (@() gsmbp_linear (m, 0, r.x, [], "drop", "theta"));
  gsmbp_check ("top: nutation cannot be dropped", ...
               ! isempty (strfind (said, "theta cannot be dropped: the rate of ")));
end

## u = R i + K w, K i = B w
function motor ()
  m = gsmbp_fixture ("case_17a");
  x = [0; 100; 0];
  r = gsmbp_trim (m, x, [], "steady", "theta", "free", "motor.v");
  [Ra, K, B] = deal (1.2, 0.062, 0.00009);
  gsmbp_check ("motor at speed: its current and voltage", ...
               [r.x(3) - B * 100 / K; r.v - (Ra * B / K + K) * 100], 1e-12);
  r = gsmbp_trim (m, x, 24, "steady", "theta", "free", "theta_d");
  gsmbp_check ("motor under 24 V: its speed", r.x(2) / (24 / (Ra * B / K + K)) - 1, 1e-12);
  gsmbp_check ("motor: what runs", isequal (r.running, {"theta"}));
  sys = gsmbp_linear (m, 0, r.x, r.v, "drop", "running");
  J = 0.00012;
  gsmbp_check ("motor: speed and current are left", ...
               sys.a - [-B / J, K / J; -K / 0.0035, -Ra / 0.0035], 1e-9);
  k = gsmbp_mck (m, 0, r.x, r.v, "drop", "theta");
  gsmbp_check ("motor: M u' + C u = E i", [k.M - J, k.C - B, k.E - K], 1e-14);
  said = gsmbp_complaint (@() gsmbp_trim (m, x, 24, "steady", "theta"));
  gsmbp_check ("motor: with speed and voltage given there is none", ...
               ! isempty (strfind (said, "no steady motion found near the guess")));
end

## a slider-crank about its equilibrium: one freedom, K is the second derivative of the potential
function second_order ()
  m = gsmbp_fixture ("case_15a");
  k = gsmbp_mck (m, 0, zeros (4, 1), 0);
  p = m.par;
  gsmbp_check ("cart and pole: M, C, K, B", ...
               [k.M - [p.mc + p.mp, p.mp * p.l; p.mp * p.l, p.jp + p.mp * p.l ^ 2], ...
                k.C - diag([p.b, p.c]), k.K - diag([0, -p.mp * p.g * p.l]), k.B - [1; 0]], 1e-13);
  gsmbp_check ("cart and pole: their parts", [k.S - k.K, k.N, k.D - k.C, k.G], 1e-14);
end

## a pendulum on a shaft that a motion turns: steady at cos(th) = g/(W^2 l), it swings with
## W sin(th)
function driven ()
  m = gsmbp_fixture ("steady_driven");
  [W, l] = deal (m.par.W, m.par.l);
  th = acos (m.par.g / (W ^ 2 * l));
  for t = [0, 3]
    r = gsmbp_trim (m, [W * t; 1; 0; zeros(3, 1)], [], "steady", "ps", "time", t);
    gsmbp_check (sprintf ("driven shaft at %g s: steady motion", t), ...
                 r.x - [W*t; th; -2*W*t; W; 0; -2*W], 1e-12);
    gsmbp_check ("driven shaft: what runs", isequal (r.running, {"ps", "we"}));
  end
  s = gsmbp_simulate (m, gsmbp_trim (m, [0; th; 0; W; 0; -2*W], [], "steady", "ps").x, 0:0.5:5);
  gsmbp_check ("driven shaft: the run stays there", s.x(:,2) - th, 1e-8);
  f = gsmbp_modes (m, [0; th; 0; W; 0; -2*W]).frequency;
  gsmbp_check ("driven shaft: frequency, relative", f / (W * sin (th)) - 1, 1e-9);
  uneven = gsmbp_set (m, "d", 0.01);
  said = gsmbp_complaint (@() gsmbp_trim (uneven, [0; th; 0; W; 0; 0], [], "steady", "ps"));
  gsmbp_check (["a shaft that turns unevenly: " said], ...
               ! isempty (strfind (said, "no steady motion")));
  said = gsmbp_complaint (@() gsmbp_trim (m, [0; th; 0; W; 0; 0]));
  gsmbp_check ("rest of a driven shaft names \"steady\"", ...
               ! isempty (strfind (said, "\"steady\"")));
end

function refused ()
  m = gsmbp_fixture ("case_15a");
  x = [0; 0.3; 1; 0];
  complain = @(f) gsmbp_complaint (f);
  said = complain (@() gsmbp_trim (m, x, 0, "steady", "thete"));
  gsmbp_check ("an unknown coordinate", ...
               ! isempty (strfind (said, "unknown coordinate \"thete\", did you mean \"theta\"")));
  said = complain (@() gsmbp_trim (m, [0; 0; 0; 5], [], "steady", "theta", "free", "F"));
  gsmbp_check ("a pole that turns on a cart that stands is no steady motion", ...
               ! isempty (strfind (said, "no steady motion")));
  said = complain (@() gsmbp_linear (m, 0, zeros (4, 1), 0, "drop", "y"));
  gsmbp_check ("dropping what is unknown", ! isempty (strfind (said, "found \"y\"")));
  d = gsmbp_fixture ("rolling_disc");
  said = complain (@() gsmbp_trim (d, d.initial, [], "steady", "e1"));
  gsmbp_check ("Euler parameters do not run steadily", ...
               ! isempty (strfind (said, "e1 has no speed of its own")));
  lastwarn ("");
  sys = gsmbp_linear (m, 0, zeros (4, 1), 0, "drop", "x");
  gsmbp_check ("an output that follows what is dropped is left out, with a warning", ...
               isequal (sys.outname, {"angle"}) && ...
               ! isempty (strfind (lastwarn (), "the output position depends on x")));
end
