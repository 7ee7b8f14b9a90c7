## lossy_gear: a rack and a worm (tests/data/r3_rack_worm), a hoist that locks itself
## (r3_worm_hoist), closed forms of LossyGear of the Modelica Standard Library with the rotor before
## the mesh, several gears at once against a fixed point, energies, derivatives, gears that jam.

function test_lossy_gear ()
  worm ();
  hoist ();
  racks ();
  arm ();
  ranges ();
end

## what a scene refuses gsmbp_set refuses
function ranges ()
  m = gsmbp_fixture ("gear_worm");
  for c = {"ef", 1.2, "1-ef must not be negative"; "ef", 0, "ef must be above 0"; ...
           "eb", 1.1, "1-eb must not be negative"}'
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

function v = inputs_of (m, varargin)
  v = zeros (numel (m.inputs), 1);
  for k = 1:2:numel (varargin)
    v(strcmp (m.inputs, varargin{k})) = varargin{k+1};
  end
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
