## Events: friction that sticks, rigid stops. Closed forms, laws of impact in trees and loops,
## energy with what impacts take, both methods, samples between.

function test_events ()
  slide ();
  breakaway ();
  ball ();
  far_end ();
  pendulum ();
  arm ();
  crank ();
  rest ({"dp853", "radau"});
  taut ();
  dead_centre ();
  computer ();
  blocks ();
  slow_starts ();
  strut ();
  by_radau ();
end

## 1 kg under 1.5 sin (pi t) N against Coulomb friction of 1 N, from rest: it slides from p = asin
## (2/3)/pi until its speed is 0, then sticks until p + 1
function slide ()
  m = gsmbp_fixture ("event_slide");
  p = asin (2/3) / pi;
  speed = @(t) 1.5 / pi * (cos (pi * p) - cos (pi * t)) - (t - p);
  way = @(t) 1.5 / pi * cos (pi * p) * (t - p) - 1.5 / pi ^ 2 * (sin (pi * t) - sin (pi * p)) ...
      - (t - p) ^ 2 / 2;
  stops = fzero (speed, [1, 1.2], optimset ("TolX", 1e-16));
  wanted = [way(1); way(stops) - way(1); way(1); way(stops) - way(1)];   # at 1, 2, 9, 10 s
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [0 0], [0 1 2 9 10], "method", method{1}, "input", 0);
    what = ["stick and slip, " method{1}];
    gsmbp_check ([what ": position at 1, 2, 9 and 10 s"], r.x(2:end,1) - wanted, 1e-10);
    gsmbp_check ([what ": the end is 1.9713 mm, to the digits of the table"], ...
                 r.x(end,1) - 1.9713e-3, 5e-8);
    gsmbp_check ([what ": times of the 19 events"], ...
                 r.events.t - [p; reshape([stops; p + 1] + (0:8), [], 1)](1:19), 1e-10);
    gsmbp_check ([what ": speed is exactly 0 where it sticks"], ...
                 r.events.after(r.events.mode == 0,2), 0);
    printf ("   %s: %d calls of the right-hand side, %d steps\n", what, r.stats.calls, ...
            r.stats.accepted);
  end
end

## a ramp breaks away at Fs; a push below Fs does not move; the Stribeck friction falls to Fc
function breakaway ()
  m = gsmbp_set (gsmbp_fixture ("event_slide"), "amplitude", 0, "fs", 1.5, "fv", 2);
  ramp = mkpp ([0 10], [0.5 0]);
  r = gsmbp_simulate (m, [0 0], [0 2.9 3.1 10], "input", ramp);
  gsmbp_check ("ramp of 0.5 N/s: breaks away at 3 s", r.events.t - 3, 1e-9);
  gsmbp_check ("ramp: nothing moves before", r.x(1:2,:), 0);
  f = @(t, x) [x(2); 0.5*t - 2*x(2) - 1 - 0.5*exp(-(x(2)/0.01)^2)];
  [~, y] = ode45 (f, [3, 10], [0; 1e-12], odeset ("RelTol", 1e-10, "AbsTol", 1e-13));
  gsmbp_check ("ramp: Stribeck friction behind it, against ode45", r.x(end,:) - y(end,:), 1e-7);
  r = gsmbp_simulate (m, [0 0], [0 5], "input", 1.4999);
  gsmbp_check ("a push of 1.4999 N moves nothing in 5 s", [r.x(end,:), r.stats.events], 0);
  ## a step of the push at a break is seen at once; steps to and fro
  r = gsmbp_simulate (m, [0 0], [0 1 2 3], "input", mkpp (0:3, [0; 4; 0]));
  gsmbp_check ("a push that jumps to 4 N at 1 s: it moves from then on", r.events.t(1) - 1, 0);
  gsmbp_check ("a mode that is given stays: forward at rest under a push", ...
               gsmbp_simulate (m, [0 0], [0 1], "input", 4, "modes", 1).x(end,1) > 0.1);
  said = gsmbp_complaint (@() gsmbp_simulate (m, [0 0], [0 1], "input", [4 1]));
  gsmbp_check (["a mode among the inputs: " said], ...
               any (strfind (said, "is no input: expected 0 in its place")));
  said = gsmbp_complaint (@() gsmbp_ensemble (m, [0 0], [0 1], "inputs", [4 0; 4 -1]));
  gsmbp_check (["of many runs: " said], any (strfind (said, "or that of option modes; found -1")));
  r = gsmbp_simulate (m, [0 0], [0 1], "input", [4 1], "modes", 1);
  gsmbp_check ("one that is that of option modes", ...
               r.x - gsmbp_simulate (m, [0 0], [0 1], "input", 4, "modes", 1).x, 0);
end

## falls from 1 m, restitution 0.8: impact n at t1*(1 + 2*(e + .. + e^n)), heights e^(2 n); rests at
## last
function ball ()
  m = gsmbp_fixture ("event_ball");
  g = 9.81;
  for method = {"dp853", "rk4", "radau", "gauss", "cvode", "auto"}
    r = gsmbp_simulate (m, [1 0 0 3], 0:0.25:6, "method", method{1}, "step", 1e-2);
    on = r.events.number == 1;
    t = r.events.t(on);
    n = (0:numel (t) - 1)';
    t1 = sqrt (2 / g);
    what = ["ball, " method{1}];
    ## cvode: errors of its tolerance, beside which the last bounces are small
    bdf = strcmp (method{1}, "cvode");
    gsmbp_check ([what ": times of the impacts"], t - t1 * (1 + 2 * 0.8 * (1 - 0.8 .^ n) / 0.2), ...
                 1e-11 + 1e-5 * bdf);
    ## of the smallest: 4e-10 m
    gsmbp_check ([what ": heights between impacts e^(2 n)"], ...
                 (r.events.after(on,3)(1:end-1) .^ 2 / (2 * g) ./ 0.64 .^ (n(1:end-1) + 1) - 1) ...
                 .* 0.64 .^ (bdf * n(1:end-1)), 1e-9);
    gsmbp_check ([what ": loses 1 - e^2 of its energy at each, J of 20"], ...
                 r.events.loss(on)(1:end-1) - 0.36 * 2 * g * 0.64 .^ n(1:end-1), ...
                 1e-12 + 1e-8 * bdf);
    gsmbp_check ([what ": number of impacts until the rebound is below 1e-4 m/s"], ...
                 numel (t) - ceil (log (1e-4 / sqrt (2 * g)) / log (0.8)), 0);
    gsmbp_check ([what ": rests on the floor"], [r.x(end,[1, 3]), r.v(end,1) + 1], 1e-12);
    gsmbp_check ([what ": all its energy is accounted for"], sum (r.events.loss(on)) - 2 * g, ...
                 1e-10 + 1e-7 * bdf);
    off = r.events.number == 2;
    gsmbp_check ([what ": puck between walls, e = 1: every second"], ...
                 r.events.t(off) - (2/3:5.9)', 1e-11);
  end
  r = gsmbp_simulate (gsmbp_set (m, "e1", 0), [1 0 0 3], [0 1], "input", []);
  gsmbp_check ("e = 0: one impact, then contact", ...
               [sum(r.events.number == 1) - 1, r.x(end,[1, 3])], 1e-13);
  ## resting from the start; thrown up again by nothing; no weight: contact or not, it stays
  r = gsmbp_simulate (m, [0 0 0 0], [0 2]);
  gsmbp_check ("a ball laid on the floor stays", [r.x(end,:), r.stats.events], 0);
end

## an end that is far away is no reason to rest in the air: at the top of a bounce the ball is slow
function far_end ()
  m = gsmbp_fixture ("stop_far");
  for top = [1, 1e3, 1e6, 1e9]
    far = gsmbp_set (m, "top", top);
    r = gsmbp_simulate (far, [0.5, 0], 0:5);
    hits = ceil (log (1e-4 / sqrt (2 * 9.81 * 0.5)) / log (0.7));
    gsmbp_check (sprintf ("an end at %g m: it rests on the floor, after %d impacts", top, hits), ...
                 abs (r.x(end,1)) <= 1e-13 && r.v(end) == -1 ...
                   && nnz (r.events.number == 1) == hits);
    r = gsmbp_simulate (far, [1e-3, 0], [0, 0.01]);
    gsmbp_check ("... from rest 1 mm above it falls", r.x(end,1) - 1e-3 + 9.81 / 2 * 1e-4, 1e-12);
    said = gsmbp_complaint (@() gsmbp_simulate (far, [-0.1, 0], [0, 1]));
    gsmbp_check (["... a start 0.1 m below it is refused: " said], ...
                 ! isempty (strfind (said, "beyond an end of the stop floor: expected 0 to ")));
    said = gsmbp_complaint (@() gsmbp_simulate (far, [0.1, 0], [0, 1], "modes", [-1, 0]));
    gsmbp_check (["... so is contact 0.1 m above it: " said], ! isempty (strfind (said, "floor")));
  end
end

## impact speeds e^n*w0, times between by the elliptic integral of each swing
function pendulum ()
  m = gsmbp_fixture ("event_pendulum");
  I = 0.04 + 2 * 0.09;
  G = 2 * 9.81 * 0.3;
  ## up and back: half a period, sin^2 (amplitude/2) = I w^2/(4 G)
  swing = @(w) 2 * sqrt (I / G) * ellipke (I * w ^ 2 / (4 * G));
  w0 = sqrt (2 * G / I * (1 - cos (2)));
  r = gsmbp_simulate (m, [2 0 0 0], [0 8], "rtol", 1e-12);
  on = strcmp (r.events.device, "S");
  n = (0:sum (on) - 1)';
  gsmbp_check ("pendulum against a stop: speeds of impact e^n*w0", ...
               r.events.before(on,3) ./ (w0 * 0.7 .^ n) + 1, 1e-9);
  gsmbp_check ("pendulum against a stop: times between impacts", ...
               diff (r.events.t(on)) - arrayfun (swing, w0 * 0.7 .^ (n(1:end-1) + 1)), 1e-9);
  said = gsmbp_complaint (@() gsmbp_simulate (m, [-1 0 0 0], [0 1]));
  gsmbp_check ("a start beyond a stop is an error that names it",
               ! isempty (strfind (said, ["beyond an end of the stop S: expected 0 to 100, " ...
                                          "found -1"])));
  x = [1 0 0 0]';
  v = zeros (m.sizes.nv, 1);
  v(m.events(1).input) = 0.5;
  for call = {@() m.rhs(0, x, v), @() gsmbp_fixture("batch_stop").rhs_v (0, [x x], [0.5, 0])}
    gsmbp_check ("a mode of 0.5 among the inputs is an error that tells it",
                 ! isempty (strfind (gsmbp_complaint (call{1}),
                                     "a mode: expected -1, 0 or 1, found 0.5")));
  end
  [~, ~, ~, info] = m.rst (0, x, 0 * v, zeros (m.sizes.nmode, 1), 0);
  gsmbp_check ("modes in their range are taken", info, 0);
  said = gsmbp_complaint (@() gsmbp_trim (m, [1; 0; 0; 0]));
  gsmbp_check ("no Jacobian where there are events, and what could help",
               ! isempty (strfind (said, "event_pendulum has events (")));
  gsmbp_check ("pendulum against a stop: loss (1 - e^2)*I*w^2/2", ...
               r.events.loss(on) ./ (0.5 * I * (w0 * 0.7 .^ n) .^ 2) - 0.51, 1e-9);
end

## double pendulum, stops at the elbow, friction in both joints
function arm ()
  m = gsmbp_set (gsmbp_fixture ("event_arm"), "vs", 0.05);
  p = m.par;
  x0 = [1.5 0.3 0 5];
  t = 0:0.02:6;
  r = gsmbp_simulate (m, x0, t, "input", 0, "rtol", 1e-12);
  s = gsmbp_simulate (m, x0, t, "input", 0, "rtol", 1e-8);
  gsmbp_check ("arm: tolerances of 1e-12 and 1e-8", r.x - s.x, 1e-4);
  gsmbp_check ("arm: the same events", ...
               isequal (r.events.number, s.events.number) ...
                 && isequal (r.events.mode, s.events.mode));
  k = gsmbp_simulate (m, x0, t, "input", 0, "method", "rk4", "step", 5e-4);
  gsmbp_check ("arm: rk4 against dp853", r.x - k.x, 1e-6);
  gsmbp_check ("arm: stops are never passed", [r.x(:,2) - 1; -0.5 - r.x(:,2)] <= 1e-12);
  mode = r.v(:,[3, 4]);
  gsmbp_check ("arm: a joint that slides moves as its mode says, one that sticks does not", ...
               all ((mode .* r.x(:,3:4))(:) >= -1e-9) ...
                   && all (abs (r.x(:,3:4)(mode == 0)) <= 1e-13));
  printf (["   arm: %d events, %d calls of the right-hand side, %.0f times faster " ...
           "than real time\n"], r.stats.events, r.stats.calls, 6 / r.stats.seconds);
  audit ("arm", m, x0, 6, 0, r);
  a = gsmbp_simulate (m, x0, t, "input", 0, "audit", 10).audit;
  gsmbp_check ("arm: audit within the run", a.error, 1e-8);
  impact_law ("arm", m, r, p.e);
  ## a push large enough presses the elbow on its stop and rests there
  r = gsmbp_simulate (gsmbp_set (m, "e", 0.3), [0 0 0 0], [0 20], "input", 0);
  gsmbp_check ("arm: comes to rest by friction", r.x(end,3:4), 1e-12);
end

## slider-crank: the slider hits a stop, friction in the guide
function crank ()
  m = gsmbp_fixture ("event_crank");
  x0 = gsmbp_assemble (m, [0.5; -0.1; 0; 0; 0; 0]);
  last = [];
  for way = {"projection", "partitioning", "kane"}
    r = gsmbp_simulate (m, x0, 0:0.05:4, "input", 8, "rtol", 1e-11, "loops", way{1});
    what = ["slider-crank, " way{1}];
    gsmbp_check ([what ": loop stays closed"], [r.stats.drift.phi, r.stats.drift.phidot], 1e-10);
    gsmbp_check ([what ": slider does not pass the stop"], -0.2 - r.x(:,3) <= 1e-11);
    impact_law (what, m, r, m.par.e);
    last(end+1,:) = r.x(end,1:3);
  end
  gsmbp_check ("slider-crank: three ways, one end", last - last(1,:), 1e-7);
  printf ("   slider-crank: %d events\n", r.stats.events);
  gsmbp_check ("slider-crank: pressed on the stop at last", [r.x(end,3) + 0.2, r.x(end,6)], 1e-9);
  audit ("slider-crank", m, x0, 4, 8, gsmbp_simulate (m, x0, [0 4], "input", 8, "rtol", 1e-12));
  r = gsmbp_simulate (m, x0, [0 4], "input", 2, "rtol", 1e-12);
  gsmbp_check ("slider-crank: friction in the guide holds it under 2 N m", ...
               [r.x(end,:) - x0', r.stats.events], 1e-11);
end

## pressed on the stop for ten hours: it neither creeps nor has more events, whatever the tolerance
function rest (methods_)
  m = gsmbp_fixture ("event_crank");
  x0 = gsmbp_assemble (m, [0.5; -0.1; 0; 0; 0; 0]);
  for method = methods_
    for rtol = [1e-4, 1e-7]
      o = {"input", 8, "rtol", rtol, "method", method{1}};
      r = gsmbp_simulate (m, x0, [0 10 3600 36000], o{:});
      brief = gsmbp_simulate (m, x0, [0 10], o{:});
      what = sprintf ("slider-crank, %s, %g: ten hours on the stop", method{1}, rtol);
      gsmbp_check (what, [r.x(3:end,3) + 0.2, r.x(3:end,6)] / rtol, 1);
      gsmbp_check ([what ": no event there"], r.stats.events - brief.stats.events, 0);
    end
  end
end

## A mass that swings on a string for a thousand seconds, and in lanes: its length stays, and it is
## a pendulum with the angle alone.
function taut ()
  m = gsmbp_fixture ("event_taut");
  x0 = [0.6 -0.8 0 0];
  far = @(x) max (abs (hypot (x(:,1), x(:,2)) - 1));
  cvode = {{"cvode"}, {}}{2 - gsmbp_has_sundials()};
  for method = [{"dp853", "rk4", "radau", "gauss"}, cvode]
    for rtol = [1e-4, 1e-7]
      r = gsmbp_simulate (m, x0, [0 1 10 100 1000], "rtol", rtol, "method", method{1}, ...
                          "step", 1e-2);
      what = sprintf ("a taut string, %s, %g", method{1}, rtol);
      gsmbp_check ([what ": no event"], r.stats.events, 0);
      gsmbp_check ([what ": its length"], far (r.x), 3 * rtol);
    end
  end
  one = gsmbp_simulate (m, x0, 0:0.5:20, "rtol", 1e-11);
  inertia = @(q) 1.1 * cos (q) ^ 2 + sin (q) ^ 2;   # the sledge goes with the bob
  rate = @(t, x) [x(2); (0.1*sin(x(1))*cos(x(1))*x(2)^2 - 9.81*sin(x(1))) / inertia(x(1))];
  [~, x] = ode45 (rate, 0:0.5:20, [atan2(0.6, 0.8); 0], odeset ("RelTol", 1e-12, "AbsTol", 1e-12));
  gsmbp_check ("a taut string: a pendulum", one.x(:,1) - sin (x(:,1)), 1e-8);
  e = gsmbp_ensemble (m, x0, [0 10 100], "rtol", 1e-7, "parameters", struct ("g", 9:0.1:10.6));
  gsmbp_check ("a taut string, in lanes", e.lanes && all (e.ok));
  gsmbp_check ("a taut string, in lanes: its length", far (squeeze (e.x(end,:,:))'), 3e-7);
end

## a free crank whose slider rubs: through its dead centres, where the slider rests for an instant
## and cannot be held; what it loses is the friction times the way of the slider
function dead_centre ()
  m = gsmbp_fixture ("event_dead_centre");
  energy = @(x) x(4:6) * m.mas (0, x(1:3)') * x(4:6)' / 2;
  at = @(theta) 0.1 * cos (theta) + sqrt (0.16 - 0.01 * sin (theta) .^ 2);
  for start = [pi/2, 0, pi; 8, 20, 3]
    rough = [start(1); -start(1); at(start(1)); start(2); 0; 0];
    x0 = gsmbp_assemble (m, rough, "hold", "theta");
    for method = {"dp853", "rk4"; 1e-8, 1e-10}
      for way = {"projection", "partitioning", "kane"}
        r = gsmbp_simulate (m, x0, 0:0.05:1.5, "input", 0, "method", method{1}, "step", 1e-4, ...
                            "rtol", 1e-12, "loops", way{1});
        what = sprintf ("dead centres, %g rad/s from %.2f rad, %s, %s", start(2), start(1), ...
                        method{1}, way{1});
        ends = r.x([1 end],1);
        points = [ends(1), pi * (ceil (ends(1) / pi):floor (ends(2) / pi)), ends(2)];
        lost = 200 * sum (abs (diff (at (points))));
        gsmbp_check ([what ": at least one is passed"], numel (points) > 2);
        gsmbp_check ([what ": energy lost is that of the friction, of all"], ...
                     (energy (r.x(end,:)) + lost) / energy (r.x(1,:)) - 1, method{2});
      end
    end
  end
  ## from rest in a dead centre a torque turns it; the friction is against the motion
  x0 = gsmbp_assemble (m, [0; 0; 0.5; 0; 0; 0], "hold", "theta");
  r = gsmbp_simulate (m, x0, [0 3], "input", 5, "rtol", 1e-12);
  gsmbp_check ("from rest in a dead centre: 5 N m lift it out and 200 N stop it", ...
               [5 * r.x(end,1) - 200 * (0.5 - at(r.x(end,1))) - energy(r.x(end,:)), ...
                r.x(end,1) > 0.39 && r.x(end,1) < 0.41, r.x(end,4)] - [0, 1, 0], 1e-9);
end

## each impact: the port's speed is -e times the one before (or 0, contact), momentum changes only
## along the constraints and the port
function impact_law (what, m, r, e)
  d = m.sizes;
  u = d.nq + (1:d.nu);
  S = find (strcmp ({m.events.kind}, "stop"));
  port = d.nq + d.nu * (strcmp (m.name, "event_arm") * 0) ...
      + find (strcmp (m.coordinates, {"q2", "s"}{1 + (d.nlam > 0)}));
  rows = find (r.events.number == S & any (r.events.before(:,u) != r.events.after(:,u), 2))';
  speed = momentum = [];
  for k = rows
    q = r.events.before(k,1:d.nq)';
    jump = (r.events.after(k,u) - r.events.before(k,u))';
    h = double (1:d.nu == port - d.nq);
    H = h;
    if (d.nlam > 0)
      [~, ~, A] = m.con (r.events.t(k), q);
      H = [A; h];
    end
    y = m.mas (r.events.t(k), q) * jump;
    momentum(end+1) = norm (y - H' * (H' \ y)) / norm (y);
    if (r.events.mode(k) == 0)
      speed(end+1) = r.events.after(k,port) / r.events.before(k,port) + e;
    end
  end
  gsmbp_check (sprintf ("%s: %d impacts, speed after is -e times that before", what, ...
                        numel (speed)), speed, 1e-9);
  gsmbp_check ([what ": impulses act on the port and the constraints alone"], momentum, 1e-9);
  gsmbp_check ([what ": every impact takes energy"], r.events.loss(rows) > 0);
end

## energy: kinetic and potential at the end, what went in, what friction took between the events
## (Gauss' rule of five points), what impacts took
function audit (what, m, x0, stop, input, first)
  [V, D] = eig (diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), 1) ...
                  + diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), -1));
  node = (1 + diag (D)) / 2;
  weight = V(1,:)' .^ 2;
  edges = unique ([0:0.002:stop, first.events.t', stop]);
  edges = edges([true, diff(edges) > 1e-9]);
  edges(end) = stop;
  h = diff (edges);
  at = edges(1:end-1) + h .* node;
  r = gsmbp_simulate (m, x0, [0, at(:)', stop], "input", input, "rtol", 1e-12);
  e = cell2mat (arrayfun (@(i) m.ene (r.t(i), r.x(i,:)', r.v(i,:)')(:), 1:numel (r.t), ...
                          "UniformOutput", false));
  gone = @(p) sum (h .* (weight' * reshape (p(2:end-1), numel (node), [])));
  E = sum (e(1:3,:));
  passed = gone (abs (e(4,:))) + gone (e(5,:)) + sum (r.events.loss);
  gsmbp_check ([what ": energy audit, losses of impacts counted in"], ...
               (E(end) - E(1) - gone (e(4,:)) + gone (e(5,:)) + sum (r.events.loss)) / passed, ...
               1e-8);
  gsmbp_check ([what ": friction never gives energy"], e(5,:) >= -1e-9);
end

## a cart under a digital PID: its integral breaks the friction, at samples only
function computer ()
  m = gsmbp_set (gsmbp_fixture ("event_pendulum"), "vs", 0.01);
  r = gsmbp_simulate (m, [0 0.03 0 0], [0 8], "input", 0.1);
  on = strcmp (r.events.device, "F");
  free = r.events.t(on & r.events.mode != 0);
  late = free(free > 0) / 0.002;
  gsmbp_check ("cart under a computer: hunts, breaks away again and again", numel (late) >= 3);
  gsmbp_check ("cart under a computer: breaks away at samples only", late - round (late), 1e-8);
  gsmbp_check ("cart under a computer: within 5 mm at last", r.x(end,2) - 0.1, 5e-3);
end

## six masses that stick and slide in all combinations
function blocks ()
  m = gsmbp_set (gsmbp_fixture ("event_blocks"), "vs", 0.05);
  r = gsmbp_simulate (m, zeros (12, 1), 0:0.1:100, "rtol", 1e-10, "audit", 10);
  mode = r.v(:,[m.events.input]);
  u = r.x(:,7:12);
  gsmbp_check ("six masses: they stick and slide", [any(mode == 0), any(mode == 1)]);
  gsmbp_check ("six masses: what slides moves as its mode says, what sticks does not", ...
               all ((mode .* u)(:) >= -1e-9) && all (u(mode == 0) == 0));
  gsmbp_check ("six masses: audit through all events", r.audit.error, 1e-8);
  printf ("   six masses: %d events in 100 s, %.0f times faster than real time\n", ...
          r.stats.events, 100 / r.stats.seconds);
end

## a start slower than 1e-9 of the Stribeck speed is at rest, whatever its sign
function slow_starts ()
  m = gsmbp_fixture ("event_strut");
  slow = 1e-9 * 0.01 * sqrt (2);   # of the block: the strut stands at 45 degrees
  mode = speed = [];
  for u = slow * [-0.9, -1e-8, 0, 1e-8, 0.9, 1.1]
    r = gsmbp_simulate (m, [0 u 0], [0 1e-3], "input", 5);
    mode(end+1) = r.v(1, m.events.input);
    speed(end+1) = r.x(1,2);
  end
  gsmbp_check ("slow starts stick, a faster one slides", isequal (mode, [0 0 0 0 0 1]));
  gsmbp_check ("slow starts are at rest", speed(1:5), 1e-30);
end

## what holds a port between two points loads the joints: a strut at 45 degrees that takes the push
## p presses the block with p more onto its rail
function strut ()
  m = gsmbp_fixture ("event_strut");
  r = gsmbp_simulate (m, [0 0 0], [0 3], "input", 5);
  y = m.out (3, r.x(end,:)', r.v(end,:)')(:)';
  miss = y(! strcmp (m.outputs, "bears.x")) - (2*9.81 + 5);   # bears.y, cell, ideal
  gsmbp_check ("a strut that sticks: nothing moves", r.x(end,1:2), 0);
  gsmbp_check ("a strut that sticks: what the rail bears", ...
               [miss([1, 3]), y(strcmp (m.outputs, "bears.x"))], 1e-12);
  gsmbp_check ("a strut that sticks: a sensor of it with a lag", miss(2), 1e-9);
end

## radau meets the events of dp853, in the same order at the same times
function by_radau ()
  arm = gsmbp_fixture ("event_arm");
  crank = gsmbp_fixture ("event_crank");
  blocks = gsmbp_fixture ("event_blocks");
  cases = {"arm", arm, [1.5; 0.3; 0; 5], 0:0.1:2, {"input", 0}
           "slider-crank", crank, gsmbp_assemble(crank, crank.initial), 0:0.1:2, {"input", 8}
           "six masses", blocks, zeros(12, 1), 0:0.5:20, {}};
  for c = cases'
    [what, m, x0, t, given] = deal (c{:});
    a = gsmbp_simulate (m, x0, t, given{:}, "rtol", 1e-11);
    r = gsmbp_simulate (m, x0, t, given{:}, "rtol", 1e-11, "method", "radau");
    gsmbp_check ([what " by radau: the same events"], isequal (a.events.number, r.events.number));
    gsmbp_check ([what " by radau: at the same times"], a.events.t - r.events.t, 1e-7);
    gsmbp_check ([what " by radau: the same motion"], a.x - r.x, 1e-7);
  end
end
