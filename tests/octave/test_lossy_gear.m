## lossy_gear: a rack and a worm (tests/data/r3_rack_worm), a hoist that locks itself
## (r3_worm_hoist), closed forms of LossyGear of the Modelica Standard Library with the rotor before
## the mesh, several gears at once against a fixed point, energies, derivatives, gears that jam.

function test_lossy_gear ()
  worm ();
  hoist ();
  racks ();
  arm ();
  cascade ();
  harmonic ();
  redundant ();
  ranges ();
  at_modes ();
end

## what a scene refuses gsmbp_set refuses
## a Jacobian at given modes: a worm held, and on the point of slipping under L = -16 N*m, where the
## worm's effort is 16/(n*ef) = 1 N*m; modes are no inputs
function at_modes ()
  m = gsmbp_fixture ("gear_worm");
  r = gsmbp_trim (m, [0.3; 0], [0; 0; -16]);
  gsmbp_check ("gsmbp_trim: a worm that holds", r.x - [0.3; 0], 0);
  r = gsmbp_trim (m, [0.3; 0], [1; 0; -16], "free", "M.effort");
  gsmbp_check ("gsmbp_trim: at the mode of slip", r.v - [1; 1; -16], 1e-12);
  mode = ["G.mode is the mode of an event (0: holds, -1 or 1: slips), no input; expected " ...
          "inputs (M.effort"];
  for f = {@() gsmbp_simulate(m, m.initial, [0 0.01], "input", {"G.mode", 1}), ...
           @() gsmbp_simulate(m, m.initial, [0 0.01], "input", struct("G_mode", 1)), ...
           @() gsmbp_trim(m, [0.3; 0], [0; 0; -16], "free", "G.mode"), ...
           @() gsmbp_trim(m, [0.3; 0], [0; 0; -16], "steady", "q", "free", {"M.effort", "G.mode"})}
    text = gsmbp_complaint (f{1});
    gsmbp_check (["a mode is no input: " func2str(f{1})(1:18)], ! isempty (strfind (text, mode)));
  end
  text = gsmbp_complaint (@() gsmbp_trim (m, [0.3; 0], [1; 0; -16]));
  gsmbp_check (["helpers: " text], ! isempty (strfind (text, "act on it: M.effort, L.effort (")));
  m = gsmbp_fixture ("gear_hoist");
  text = gsmbp_complaint (@() gsmbp_trim (m, m.initial, [0; 0]));
  gsmbp_check (text, ! isempty (strfind (text, ["no Jacobian but at given modes; derive " ...
                                                "it with request sensitivity(PARAMETER)"])));
end

function ranges ()
  m = gsmbp_fixture ("gear_worm");
  for c = {"ef", 1.2, "expected ef <= 1; found: ef = 1.2"; "ef", 0, "ef must be above 0"; ...
           "eb", 1.1, "expected eb <= 1; found: eb = 1.1"}'
    text = gsmbp_complaint (@() gsmbp_set (m, c{1:2}));
    gsmbp_check (["gsmbp_set refuses " c{3}], ! isempty (strfind (text, ["G: " c{3}])));
  end
  m = gsmbp_fixture ("design_lifter");
  text = gsmbp_complaint (@() gsmbp_set (m, "gear_ef", 0.5));
  gsmbp_check ("gsmbp_set: a smooth gear does not lock itself", ...
               ! isempty (strfind (text, "a self-locking gear has variant = event")));
  gsmbp_check ("gsmbp_set: just not", gsmbp_set (m, "gear_ef", 0.51).par.gear_ef == 0.51);
end

function [r, p] = case_of (name)
  r = structfun (@number, case_file (name, "reference.json").values, "UniformOutput", false);
  p = structfun (@(c) number (c{1}), case_file (name, "parameters.json"), ...
                 "UniformOutput", false);
end
function x = number (x)
  if (ischar (x))
    x = str2double (x);
  end
end
function s = case_file (name, file)
  here = fileparts (mfilename ("fullpath"));
  s = jsondecode (fileread (fullfile (here, "..", "data", name, file)));
end

## the worm: speeds and torques in all quadrants, what it holds, when it jams
function worm ()
  [r, p] = case_of ("r3_rack_worm");
  m = gsmbp_fixture ("gear_worm");
  [sg, cg, ca] = deal (sin (p.gam), cos (p.gam), cos (p.alp));
  ef = tan (p.gam) * (ca * cg - p.mu * sg) / (ca * sg + p.mu * cg);
  eb = (ca * sg - p.mu * cg) / (ca * cg + p.mu * sg) / tan (p.gam);
  gsmbp_check ("worm: efficiencies", [ef - r.worm_eta_fwd, eb - r.worm_eta_back], 1e-14);
  m = gsmbp_set (m, "ef", ef, "eb", eb, "Jw", p.Jw, "Jg", p.Jg);
  way = [1, 1, -1, -1, 1];
  t1 = [p.tw, p.tw, -p.tw, -p.tw, 0];
  load = [-p.TL, p.TL, -p.TL, p.TL, p.TL];
  for k = 1:5
    [x, info] = m.rhs (0, [0; way(k)], [way(k); t1(k); load(k)]);
    wanted = r.(sprintf ("worm_wheel_acc_%d", k));
    gsmbp_check (sprintf ("worm: case %d", k), x(2) / wanted - 1, 1e-13);
    gsmbp_check (sprintf ("worm: case %d, INFO", k), info == 0);
    e = m.ene (0, [0; way(k)], [way(k); t1(k); load(k)]);
    J = p.Jg + 40 ^ 2 * p.Jw;
    gsmbp_check (sprintf ("worm: case %d, energy", k), ...
                 (J * x(2) * way(k) - e(4) + e(5)) / e(5), 1e-13);
    gsmbp_check (sprintf ("worm: case %d, loses", k), e(5) > 0);
  end
  holds = @(t) m.evt (0, [0; 0], [0; t; p.TL], 0);
  for t = [r.worm_hold_t1_max, r.worm_hold_t1_min]
    gsmbp_check ("worm: at rest it holds up to this torque", holds (t) / p.TL, 1e-13);
    gsmbp_check ("worm: within", holds (t - 1e-6 * t) > 0);
    gsmbp_check ("worm: beyond", holds (t + 1e-6 * t) < 0);
  end
  dry (m, p, ef, eb);
  jams (m, r, way, t1, load);
  runs (m, p, struct ("ef", ef, "Jg", p.Jg));
end

## with friction that does not grow with the load, the gear holds up to where it begins to slide:
## T = x + h*(sqrt ((sigma*x)^2 + Tc^2) + h*delta*x) with the tooth torque x = -TL/n
function dry (m, p, ef, eb)
  Tc = 0.3;
  m = gsmbp_set (m, "Tc", Tc);
  [sigma, delta, x] = deal ((1/ef - eb) / 2, (1/ef + eb) / 2 - 1, -p.TL / 40);
  for h = [1, -1]
    t = x + delta * x + h * sqrt ((sigma * x) ^ 2 + Tc ^ 2);
    gsmbp_check ("worm: with Tc it holds up to this torque", ...
                 m.evt (0, [0; 0], [0; t; p.TL], 0) / p.TL, 1e-13);
    xd = m.rhs (0, [0; 0], [h; t; p.TL]);
    gsmbp_check ("worm: with Tc it slides beyond the same torque", xd(2), 1e-12);
  end
end

function jams (m, r, way, t1, load)
  info = @(J, k) second (gsmbp_set (m, "Jw", J), [way(k); t1(k); load(k)]);
  gsmbp_check ("worm: two solutions are reported", info (r.worm_Jw_jam / 2, 1) == 4);
  gsmbp_check ("worm: none is reported", info (r.worm_Jw_jam / 2, 5) == 4);
  gsmbp_check ("worm: below that inertia it jams", info (r.worm_Jw_jam * (1 - 1e-9), 1) == 4);
  gsmbp_check ("worm: above it does not", info (r.worm_Jw_jam * (1 + 1e-9), 1) == 0);
  text = gsmbp_complaint (@() gsmbp_simulate (gsmbp_set (m, "Jw", 5e-4), [0; 1], [0 1], ...
                                              "input", [1; 20]));
  gsmbp_check ("worm: the message names the gear", ...
               ! isempty (strfind (text, "the mesh of G jams, it has two solutions or none")));
end

function info = second (m, v)
  [~, info] = m.rhs (0, [0; v(1)], v);
end

## runs: energy, slips and holds; many at once as one by one; derivatives by parameters
function runs (m, p, start)
  v = [-2.5; p.TL];
  o = {"input", v, "rtol", 1e-11, "atol", 1e-11};
  s = gsmbp_simulate (m, [0; 3], linspace (0, 1, 11), o{:}, "audit", 1);
  gsmbp_check ("worm: it stops and moves back", numel (s.events.t) == 2 && s.x(end, 2) < -1);
  gsmbp_check ("worm: energy of the run", s.audit.error, 1e-9);
  x0 = [0, 3; 0, 2; 0, -1; 0, 0];
  for lanes = [true, false]
    many = gsmbp_ensemble (m, [], [0 0.3 1], o{:}, "starts", x0, "lanes", lanes);
    gsmbp_check ("worm: in lanes", many.lanes == lanes);
    for k = 1:4
      one = gsmbp_simulate (m, x0(k,:), [0 0.3 1], o{:});
      gsmbp_check ("worm: many runs as one", many.x(:,:,k) - one.x, 1e-9);
    end
  end
  s = gsmbp_simulate (m, [0; 3], [0 1], o{:}, "sensitivity", {"ef", "Jg"});
  for k = {"ef", "Jg"}
    p0 = start.(k{1});
    h = 1e-5 * p0;
    x = @(h) gsmbp_simulate (gsmbp_set (m, k{1}, p0 + h), [0; 3], [0 1], o{:}).x(end,:)';
    d = (x (h) - x (-h)) / (2 * h);
    S = s.dx.(k{1})(end,:)';
    gsmbp_check (["worm: derivative by " k{1}], norm (S - d) / norm (d), 1e-5);
  end
end

function hoist ()
  [r, p] = case_of ("r3_worm_hoist");
  m = gsmbp_fixture ("gear_hoist");
  x = m.rhs (0, zeros (4, 1), [1; p.Tup]);
  gsmbp_check ("hoist: acceleration", x(3) / r.a_up - 1, 1e-13);
  gsmbp_check ("hoist: least torque", m.evt (0, zeros (4, 1), [0; r.Tup_min], 0), 1e-12);
  torque = {@(t) p.Tup, @(t) 0, @(t) -p.kd * (t - p.t2), @(t) 0};
  t = [0, p.t1, p.t2, p.t3, 4];
  x0 = zeros (4, 1);
  [stops, starts] = deal ([]);
  for k = 1:4
    s = gsmbp_simulate (m, x0, t(k:k+1), "input", @(t, x) torque{k}(t), "rtol", 1e-12, ...
                        "atol", 1e-12);
    x0 = s.x(end, :)';
    stops = [stops; s.events.t(s.events.mode == 0)(:)];
    starts = [starts; s.events.t(s.events.mode != 0)(:)];
    last(k, :) = s.x(end, :);
  end
  got = [last(1, 3), last(2, 2), last(3, 3), last(4, 2), stops', starts(end)];
  wanted = [r.w_t1, r.h1, r.w_t3, r.h2, r.t_stop1, r.t_stop2, r.t_break];
  gsmbp_check ("hoist: speeds, heights, times", got ./ wanted - 1, 1e-9);
end

function racks ()
  [r, p] = case_of ("r3_rack_worm");
  m = gsmbp_fixture ("gear_rack");
  way = [1, 1, -1, -1, 1, 1];
  tau = [p.tau1, -p.tau1, -p.tau1, p.tau1, 0, 0];
  F = [-p.F1, p.F1, p.F1, -p.F1, p.F1, -p.F1];
  for k = 1:6
    x = m.rhs (0, [0; 0; way(k); way(k)], ...
               inputs_of (m, "M.effort", tau(k), "F.effort", F(k), "H.mode", way(k), ...
                          "N.effort", tau(k), "E.effort", F(k)));
    wanted = r.(sprintf ("rack_acc_%d", k));
    gsmbp_check (sprintf ("rack: case %d, smooth", k), x(3) / wanted - 1, 1e-13);
    gsmbp_check (sprintf ("rack: case %d, event", k), x(4) / wanted - 1, 1e-13);
  end
  for t = [r.rack_tau_up, r.rack_tau_down]
    v = inputs_of (m, "N.effort", t, "E.effort", -p.F1);
    gsmbp_check ("rack: at rest it holds up to this torque", m.evt (0, zeros (4, 1), v, 0), 1e-10);
  end
  ## J k^2 = m: LossyGear of the Modelica Standard Library
  m = gsmbp_set (m, "m", 100, "Jm", 2.5e-3, "r", 0.005);
  x = m.rhs (0, [0; 0; 1; 1], inputs_of (m, "M.effort", 1, "H.mode", 1, "N.effort", 1));
  a = 200 * 0.88 / (100 + 0.88 * 100);
  gsmbp_check ("rack: rotor before the mesh", x(3:4)' / a - 1, 1e-13);
end

## three gears that load each other by the inertia of the arm
function arm ()
  m = gsmbp_fixture ("gear_arm");
  g = struct ("n", {30, -20, 20}, "ef", {0.6, 0.7, 0.8}, "eb", {0.3, 0.5, 2 - 1/0.8}, ...
              "J", {0.002, 0.001, 0.0005}, "B", {0, 0.0002, 0});
  rand ("twister", 3);
  for k = 1:40
    x = [2 * pi * rand(3, 1); 4 * rand(3, 1) - 2];
    T = 6 * rand (3, 1) - 3;
    a = m.rhs (0, x, T)(4:6);
    gsmbp_check ("arm: three gears", a - fixed_point (m, g, x, T), 1e-9 * norm (a));
    e = m.ene (0, x, T);
    [M, b] = deal (m.mas (0, x(1:3)), m.bia (0, x(1:3), x(4:6)));
    gsmbp_check ("arm: no loss is negative", e(5) >= 0);
    v = m.cmd (0, [x(1:3), x(4:6), a]);
    gsmbp_check ("arm: torques of a motion", v - T, 1e-9 * norm (T));
  end
  A = m.jac (0, x, T);
  d = zeros (6);
  for k = 1:6
    h = 1e-6 * (1:6 == k)';
    d(:, k) = (m.rhs (0, x + h, T) - m.rhs (0, x - h, T)) / 2e-6;
  end
  gsmbp_check ("arm: derivatives", A - d, 1e-6 * norm (d));
  s = m.json.subroutines;
  mul = @(w) s(strcmp ({s.name}, ["GEAR_ARM_" w])).operations.mul;
  gsmbp_check ("arm: derivatives are short", mul ("JAC") < 2.5 * mul ("RHS"));
  s = gsmbp_simulate (m, x, linspace (0, 1, 5), "input", T, "audit", 1, "rtol", 1e-11, ...
                      "atol", 1e-11);
  gsmbp_check ("arm: energy of the run", s.audit.error, 1e-9);
end

function a = fixed_point (m, g, x, T)
  [M, b] = deal (m.mas (0, x(1:3)), m.bia (0, x(1:3), x(4:6)));
  [n, ef, eb, J, B] = deal ([g.n]', [g.ef]', [g.eb]', [g.J]', [g.B]');
  h = tanh (n .* x(4:6) / 0.001);
  [sigma, delta] = deal ((1 ./ ef - eb) / 2, (1 ./ ef + eb) / 2 - 1);
  loss = zeros (3, 1);
  for k = 1:400
    a = M \ (n .* (T - loss) - b);
    tooth = T - n .* B .* x(4:6) - n .* J .* a - loss;
    new = h .* (sqrt ((sigma .* tooth) .^ 2 + 0.01 ^ 2) + h .* delta .* tooth);
    loss = (loss + new) / 2;
  end
end

## gears on the shafts of others, by free bodies: motor and pinion of G; its gear, the shaft and the
## pinion of H; the wheel
function cascade ()
  [m, e] = deal (gsmbp_fixture ("gear_cascade"), gsmbp_fixture ("gear_cascade_event"));
  p = m.par;
  G = struct ("n", p.n2, "ef", 0.8, "eb", 0.7, "J", p.J2, "B", p.B2, "Tc", p.T2);
  H = struct ("n", p.n1, "ef", 0.75, "eb", 0.6, "J", p.J1, "B", p.B1, "Tc", p.T1);
  P = setfield (setfield (setfield (H, "ef", 1), "eb", 1), "Tc", 0);
  rand ("twister", 11);
  for k = 1:30
    w = sign (rand - 0.5) * (0.2 + rand);
    [T, L] = deal (8 * rand - 4, 300 * rand - 150);
    v = inputs_of (m, "LA.effort", L, "LB.effort", L, "MA.effort", -T, "MB.effort", T);
    x = [0; 0; 0; w; w; 0.3];
    [xd, info] = m.rhs (0, x, v);
    [yd, jams] = e.rhs (0, [0; w], inputs_of (e, "H.mode", sign (w), "M.effort", T, ...
                                              "L.effort", L));
    gsmbp_check ("cascade: INFO", [info, jams] == 0);
    wanted = [wheel(p.Jl, H, G, w, T, L); wheel(p.Jl, P, G, w, T, L)];
    gsmbp_check ("cascade: free bodies", [xd(4:5); yd(2)] - wanted([1 2 1]), ...
                 1e-11 * norm (wanted));
    power = m.ene (0, x, v);
    gsmbp_check ("cascade: no loss is negative", power(5) >= 0);
  end
  derivatives ("cascade", m, [0; 0; 0; 0.00002; 0.8; -0.6], v);
  v = inputs_of (e, "H.mode", -1, "M.effort", 2);
  derivatives ("cascade, event", e, [0; -0.7], v);
  loads_and_runs (p, H);
end

## acceleration of a wheel with inertia Jl and speed w under the torque L, driven by gears H and G
## and the torque T of the motor
function a = wheel (Jl, H, G, w, T, L)
  ws = H.n * w;
  x_G = @(a) tooth (G, sign (w), T - G.n * G.B * ws - G.n * G.J * H.n * a);
  x_H = @(a) tooth (H, sign (w), G.n * x_G (a) - H.B * ws - H.J * H.n * a);
  a = zero_of (@(a) Jl * a - H.n * x_H (a) - L, 1e4);
end
## x of x + loss = arriving
function x = tooth (g, h, arriving)
  [sigma, delta] = deal ((1 / g.ef - g.eb) / 2, (1 / g.ef + g.eb) / 2 - 1);
  x = zero_of (@(x) x + h * sqrt ((sigma * x) ^ 2 + g.Tc ^ 2) + delta * x - arriving, 1e7);
end
## zero of a function that rises, within +-size
function x = zero_of (f, size)
  x = fzero (f, [-size, size], optimset ("TolX", 0));
end

## derivatives beside differences
function derivatives (what, m, x, v)
  names = m.json.sensitivity;
  [A, ~, C] = m.jac (0, x, v);
  h = 1e-6 * max (abs (x), 1e-2 * (1:numel (x) <= numel (x) / 2)');
  [Ad, Cd] = deal (zeros (size (A)), zeros (size (C)));
  for k = 1:numel (x)
    e = h(k) * ((1:numel (x))' == k);
    Ad(:, k) = (m.rhs (0, x + e, v) - m.rhs (0, x - e, v)) / (2 * h(k));
    if (! isempty (C))
      Cd(:, k) = (m.out (0, x + e, v) - m.out (0, x - e, v)) / (2 * h(k));
    end
  end
  gsmbp_check ([what ": derivatives by the state"], norm (A - Ad) / norm (A), 1e-7);
  if (! isempty (C))
    gsmbp_check ([what ": of the outputs"], norm (C - Cd) / norm (C), 1e-7);
  end
  P = m.rhp (0, x, v);
  for k = 1:numel (names)
    d = 1e-6 * m.par.(names{k});
    g = (gsmbp_set (m, names{k}, m.par.(names{k}) + d).rhs (0, x, v) ...
         - gsmbp_set (m, names{k}, m.par.(names{k}) - d).rhs (0, x, v)) / (2 * d);
    gsmbp_check ([what ": derivative by " names{k}], norm (P(:, k) - g) / norm (g), 1e-7);
  end
end

## the gear with events holds the wheel up to the torque at which it begins to slide: G, which is
## smooth, loses nothing at rest; energy of runs; the torques of a motion
function loads_and_runs (p, H)
  e = gsmbp_fixture ("gear_cascade_event");
  for h = [1, -1]
    x = 40;
    T = (x + h * sqrt (((1 / H.ef - H.eb) / 2 * x) ^ 2 + H.Tc ^ 2) ...
         + ((1 / H.ef + H.eb) / 2 - 1) * x) / p.n2;
    v = inputs_of (e, "M.effort", T, "L.effort", -H.n * x);
    gsmbp_check ("cascade: at rest it holds up to this torque", e.evt (0, zeros (2, 1), v, 0), ...
                 1e-11);
  end
  o = {"audit", 1, "rtol", 1e-12, "atol", 1e-12};
  v = inputs_of (e, "M.effort", -8, "L.effort", 30);
  s = gsmbp_simulate (e, [0; 1.5], linspace (0, 0.4, 5), "input", v, o{:});
  gsmbp_check ("cascade, event: energy of the run", s.audit.error, 1e-9);
  gsmbp_check ("cascade, event: it turns back", s.x(end, 2) < -0.1);
  m = gsmbp_fixture ("gear_cascade");
  v = inputs_of (m, "MA.effort", 2, "MB.effort", 1, "MC.effort", 0.3, "LA.effort", -20);
  s = gsmbp_simulate (m, [0; 0; 0; 1.5; -1; 2], linspace (0, 0.4, 5), "input", v, o{:});
  gsmbp_check ("cascade: energy of the run", s.audit.error, 1e-9);
end

## the rotor's torque is no tooth load of the rigid harmonic drive, either
function harmonic ()
  m = gsmbp_set (gsmbp_fixture ("gear_cascade"), "T2", 0);
  p = m.par;
  [n, J, mu] = deal (50, p.J2, 1 / p.eta - 1);
  tried = 0;
  for way = [1, -1]
    for T = [1.2, -0.4, 0]
      for L = [-80, 30]
        v = inputs_of (m, "MC.effort", T, "LC.effort", L);
        x = [zeros(5, 1); way];
        Y = T - n * p.B2 * way;
        for push = [1, -1]                      # of the tooth torque
          k = 1 / (1 + way * push * mu);        # of what arrives this passes the teeth
          a = (n * k * Y + L) / (p.Jl + n ^ 2 * k * J);
          tooth = k * (Y - n * J * a);
          if (push * tooth > 0)
            tried++;
            gsmbp_check ("harmonic drive, rigid: acceleration", m.rhs (0, x, v)(6) - a, ...
                         1e-12 * abs (a));
            gsmbp_check ("harmonic drive, rigid: torque", m.out (0, x, v) - n * tooth, ...
                         1e-11 * abs (n * tooth));
          end
        end
      end
    end
  end
  gsmbp_check ("harmonic drive, rigid: one solution each", tried == 12);
end

## a gear in a loop with a row that is not needed, at poses where rounding leaves something of that
## row or nothing (not where all links lie in one line), against one equation by hand: x the torque
## behind the mesh, w > 0
##   T - Jm*n*a = x/ef (x > 0), eb*x (x < 0),   I*a = n*x - (3/2*m + mb)*g*l*cos(q)
function redundant ()
  m = gsmbp_fixture ("gear_parallel");
  p = m.par;
  I = 3 * (p.J + p.m * p.l^2 / 4) + p.mb * p.l^2;
  angles = [(-7:-1) * pi/8, (1:7) * pi/8, 1.13, -1.13, 1e-2, 1e-3, 0.5:0.37:30];
  worst = 0;
  infos = [];
  for q = angles
    load = (1.5 * p.m + p.mb) * p.g * p.l * cos (q);
    for T = [0, 3, -3, 40, -40]
      a = [p.n * T * 0.8 - load, p.n * T / 0.75 - load] ...
          ./ [I + p.n^2 * p.Jm * 0.8, I + p.n^2 * p.Jm / 0.75];
      x = (I * a + load) / p.n;
      a = a([x(1) > 0, x(2) <= 0]);
      [xd, info] = m.rhs (0, [q; -q; q; q; 7 * [1; -1; 1; 1]], T);
      worst = max (worst, max (abs (xd(5:8) - a * [1; -1; 1; 1])));
      infos(end+1) = info;
    end
  end
  gsmbp_check ("a gear in redundant loops: accelerations as by hand", worst, 1e-10);
  gsmbp_check ("... of which the rows are dependent everywhere", all (infos == 2));
end
