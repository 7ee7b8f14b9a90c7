## Gears, friction, stops, sensors and controllers in scenes: closed forms, energy, inverse then
## forward, behaviour at the hazards.

function test_mechanical ()
  slides ();
  stops ();
  clearance ();
  tight ();
  joint ();
  elastic ();
  control ();
  digital ();
  gyroscope ();
end

## stick and slip under 1.5 sin (pi t) N; creep; bristles
function slides ()
  m = gsmbp_fixture ("mech_slides");
  wanted = stick_slip (10);
  away = [];
  for vc = [1e-2, 1e-3, 1e-4, 1e-5]
    r = gsmbp_simulate (gsmbp_set (m, "vc", vc, "k0", 1e5, "k1", 300, "vb", 1e-6), zeros (5, 1), ...
                        [0 10], "input", [1.5; 0], "method", "cvode", "rtol", 1e-8, "atol", ...
                        1e-12);
    away(end+1) = r.x(end,1) / wanted - 1;
  end
  printf (["stick and slip over 10 s: the mass ends %s %% too far for vc = 1e-2, " ...
           "1e-3, 1e-4, 1e-5 m/s\n"], mat2str (100 * away, 2));
  ## the first three are known figures; the error falls with vc*log (1/vc)
  gsmbp_check ("friction: stick and slip, smooth against exact: 68, 7.5, 0.9 and 0.11 %", ...
               away ./ [0.68, 0.075, 0.009, 0.0011] - 1, 0.05);
  gsmbp_check ("bristles: stick and slip, against exact", (r.x(end,2) - wanted) / wanted, 0.03);

  ## below breakaway: creep with vc*atanh (F/Fc). The bristles bend by F/k0, over a way of -log (1 -
  ## F/Fc)*Fc/k0, and come back over log (1 + F/Fc)*Fc/k0
  m = gsmbp_set (m, "vc", 1e-3, "k0", 1e4, "k1", 400, "vb", 1e-9);
  r = gsmbp_simulate (m, zeros (5, 1), [0 5], "input", [0; 0.6], "method", "cvode");
  gsmbp_check ("friction: creep under 0.6 of Fc, m/s", r.x(end,3) - 1e-3 * atanh (0.6), 1e-10);
  gsmbp_check ("bristles: bent by 0.6 N/k0", r.x(end,5) * 1e4 / 0.6 - 1, 1e-6);
  gsmbp_check ("bristles: way before sliding", r.x(end,2) * 1e4 / -log (0.4) - 1, 1e-3);
  r = gsmbp_simulate (m, r.x(end,:)', [0 5], "method", "cvode");
  gsmbp_check ("bristles: way that is left", r.x(end,2) * 1e4 / -log (0.4 * 1.6) - 1, 1e-3);
  finite ("friction", m, zeros (5, 1), [0; 0]);
  finite ("friction at 1e6 m/s", m, [0; 0; 1e6; -1e6; 0], [0; 0]);

  ## energy through many reversals
  m = gsmbp_set (m, "vc", 0.02, "k0", 100, "k1", 10, "vb", 0.02);
  audit ("friction", m, zeros (5, 1), 4, [3; 0]);
end

## where the mass of 1 kg under 1.5 sin (pi t) N and Coulomb friction of 1 N is at time t
function x = stick_slip (t)
  p = asin (2/3) / pi;
  x = 0;
  from = p;
  d = 1;
  while (from < t)
    v = @(s) 1.5 / pi * (cos (pi * from) - cos (pi * s)) - d * (s - from);
    grid = from + (1e-3:1e-3:2);
    k = find (d * v (grid) < 0, 1);
    if (isempty (k))
      to = t;
    else
      to = min (t, fzero (v, grid(k - [1, 0])));
    end
    s = to - from;
    x += 1.5 / pi * cos (pi * from) * s - 1.5 / pi ^ 2 * (sin (pi * to) - sin (pi * from)) - d ...
        * s ^ 2 / 2;
    ## the next slip begins where the push next exceeds the friction
    f = 1.5 * sin (pi * to);
    from = to;
    if (abs (f) <= 1)
      starts = [p, 1 + p] + 2 * (0:ceil (t / 2))';
      from = min (starts(starts > to));
    end
    d = sign (sin (pi * from));
  end
end

## impact: rebound speed from the integral of v/(1 + tanh (v/vd)) on the way in and of v/(1 - tanh
## (v/vd)) on the way out, equal for every width of the corner
function stops ()
  m = gsmbp_set (gsmbp_fixture ("mech_clearance"), "g", 0, "ks", 1e5, "vd", 2, "eps_s", 1e-4);
  half = @(v, k) v ^ 2 / 4 + quadgk (@(y) y .* exp (k * 2 * y / 2) / 2, 0, v);
  away = restitution = [];
  for v0 = [0.1, 1, 5]
    r = gsmbp_simulate (m, [0; 0.1; 0; -v0; 0; 0], [0, 0.4 / v0 + 0.1 / v0], "rtol", 1e-11, ...
                        "atol", 1e-13);
    wanted = fzero (@(v) half (v, 1) - half (v0, -1), [0, v0]);
    away(end+1) = r.x(end,4) / wanted - 1;
    restitution(end+1) = wanted / v0;
  end
  printf ("stop: coefficient of restitution %s at 0.1, 1, 5 m/s\n", mat2str (restitution, 3));
  ## K eps^4/(16 x^3) at 0.1 m before the stop is 6e-16 N; the rest is the integration
  gsmbp_check ("stop: rebound speed at 0.1, 1, 5 m/s", away, 1e-8);
  m = gsmbp_set (m, "g", 9.81, "eps_s", 1e-5);
  depth = 2 * 9.81 / 1e5;
  still = m.rhs (0, [0; -depth; 0; 0; 0; 0], 0);
  gsmbp_check ("stop: rest at mg/K, of g", still(4) / 9.81, 1e-6);   # eps^4/(16 depth^4) = 4e-7
  ## never tensile: leaving at any speed the acceleration is not below -g
  pull = [];
  for v = [0.1, 10, 1000]
    leave = m.rhs (0, [0; -1e-3; 0; v; 0; 0], 0);
    pull(end+1) = leave(4);
  end
  gsmbp_check ("stop: never pulls", pull >= -9.81 - 1e-9);
  finite ("stop, edge", m, zeros (6, 1), 0);
  finite ("stop, 1e3 m/s, 1 m deep", m, [0; -1; 0; -1e3; 0; 0], 0);
  audit ("stop", gsmbp_set (m, "ks", 2e3, "eps_s", 0.01), [0; 0.5; 0; 0; 0; 0], 2, 0);
end

## wheel behind a clearance: lost motion, energy through the impacts
function clearance ()
  m = gsmbp_set (gsmbp_fixture ("mech_clearance"), "g", 0, "b", 0.01, "eps", 1e-3, "G_B", 0);
  v = 0.01;   # N m
  r = gsmbp_simulate (m, [0; 1; 0; 0; 0; 0], [0 0.05], "input", v);
  ## until the flank is reached the pinion turns alone: v t^2/(2 J), the gap of 5*0.01 rad lasts 32
  ## ms
  free = gsmbp_simulate (m, [0; 1; 0; 0; 0; 0], [0 0.02], "input", v);
  gsmbp_check ("backlash: the pinion turns alone in the gap", ...
               free.x(end,5) / (v * 0.02 ^ 2 / 2 / m.par.G_J) - 1, 1e-3);
  ## eps^4/(16 x^3) of the flanks' stiffness
  gsmbp_check ("backlash: the wheel waits, rad", free.x(end,1), 1e-6);
  gsmbp_check ("backlash: and takes the wheel with it behind the gap", r.x(end,1) > 1e-3);
  finite ("backlash, edge of the gap", m, [0; 1; 0; 0; 0.05; 0], 0);
  finite ("backlash, middle of the gap", m, [0; 1; 0; 0; 0; 0], 0);
  audit ("backlash", gsmbp_set (m, "eps", 0.003, "G_B", 1e-3), [0; 1; 1; 0; 0; 0], 1, v);
end

## the same gear without its clearance: the torque that passes the mesh is what turns the wheel
function tight ()
  m = gsmbp_fixture ("mech_tight");
  p = m.par;
  for c = [0, 0, 2, -3; 3, 0.5, 0, -1; 0, 0, 4, 5]   # speed, torque of the drive, current
    [w, T, i] = num2cell (c){:};
    xd = m.rhs (0, [0.3; w], [T; i]);
    wd = 5 * (T + 0.1*i - (p.E_B + 0.02)*5*w) / (p.iw + 25 * (0.003 + 0.004));
    y = m.out (0, [0.3; w], [T; i]);
    gsmbp_check (sprintf ("backlash, tight: acceleration, torque in the mesh %.4g N m, twist", ...
                          y(1)), [xd(2) - wd; y - p.iw * wd * [1; 1/200]], 1e-13);
  end
end

## arm behind a harmonic drive with motor, friction, stops and a spring
function joint ()
  m = gsmbp_fixture ("mech_joint");
  finite ("harmonic drive at rest", gsmbp_set (m, "w0", 1e-3, "vc", 1e-4), zeros (5, 1), 0);
  audit ("harmonic drive, friction, stop", gsmbp_set (m, "vc", 0.05, "eps", 0.02, "w0", 2), ...
         [1.8; 3; 90; 150; 0], 0.5, 5);
  forward_after_inverse ("harmonic drive with damping", m, ...
                         gsmbp_plan ("septic", [0 1 0.2], [0 1 2]));
end

function elastic ()
  m = gsmbp_fixture ("mech_elastic");
  forward_after_inverse ("elastic drive and lossy gear", m, ...
                         gsmbp_plan ("septic", [0 1; 0 -0.5], [0 1]));
  finite ("lossy gear at rest", gsmbp_set (m, "w0", 1e-4), zeros (7, 1), [0; 0]);
end

function control ()
  m = gsmbp_fixture ("mech_control");
  forward_after_inverse ("analogue controllers", m, ...
                         gsmbp_plan ("septic", [0 1; 0 -0.5; 0 0.2], [0 1]));
  ## at rest: the accelerometer feels the weight, the load cell carries it, the integral part holds
  ## the arm
  x = zeros (m.sizes.nx, 1);
  hold = 2 * 9.81 * 0.2;
  x(strcmp (m.states, "ACC.y")) = 0.1 * 9.81;
  x(strcmp (m.states, "CELL.y")) = 0.01 * 2 * 9.81;
  x(strcmp (m.states, "PID.I")) = hold / (1 - (hold / 30) ^ 8) ^ (1/8);
  ## the filters multiply a few units in the last place of 0.98 by wn^2 = 9e4
  gsmbp_check ("sensors and PID at rest: nothing moves", ...
               m.rhs (0, x, zeros (5, 1))(! strcmp (m.states, "PID.I")), 9e4 * 4 * eps);
  ## far beyond the bounds
  finite ("controllers at their bounds", m, 1e6 * ones (17, 1), 1e6 * ones (5, 1));
end

## encoder with cascade at 1 kHz, PID at 500 Hz with a delay: against the difference equations
## written down here, between the samples Runge-Kutta for the arm and the exact solution for cart
## and sensor
function digital ()
  m = gsmbp_fixture ("mech_digital");
  v = zeros (m.sizes.nv, 1);
  v(strcmp (m.inputs, "CAS.reference")) = 0.5;
  v(strcmp (m.inputs, "PID.reference")) = 1.5;
  t = 0:0.002:0.4;
  r = gsmbp_simulate (m, zeros (m.sizes.nx, 1), t, "input", v, "rtol", 1e-12, "atol", 1e-12);
  names = {"q", "s", "q_d", "s_d", "POS.y"};
  for k = 1:5
    found(:,k) = r.x(:,strcmp (m.states, names{k}));
  end
  arm = [0; 0];
  cart = [0; 0; 0];
  A = [0 1 0; 0 0 0; 20000/1.4 0 -2000/1.4];
  half = expm ([A, [0; 1/3; 0]; zeros(1, 4)] * 5e-4);
  fall = @(x, u) [x(2); (u - 2 * 9.81 * 0.2 * cos (x(1))) / 0.13];
  I = old = count = Ip = d = ep = held = 0;
  res = 2 * pi / 4000;
  q12 = 0.0048828125;
  wanted = zeros (numel (t), 5);
  for k = 0:399
    if (mod (k, 2) == 0)
      wanted(k/2+1,:) = [arm(1), cart(1), arm(2), cart(2), cart(3)];
    end
    ## encoder and cascade
    angle = res * floor (arm(1) / res + 0.5);
    speed = count * (angle - old) / 1e-3;
    raw = 3 * (10 * (0.5 - angle) - speed + I);
    u = 0.01 * floor (max (-30, min (30, raw)) / 0.01 + 0.5);
    draw = 1 / (1 + 1e-4);   # Ti = Tt
    I += 1e-3 * (10 * (0.5 - angle) - speed) / 0.1 + draw * 1e-3 * (u - raw) / (3 * 0.1);
    old = angle;
    ## PID, every second time; its output comes half a millisecond later
    next = held;
    if (mod (k, 2) == 0)
      e = 1.5 - q12 * floor (cart(3) / q12 + 0.5);
      d = (0.01 * d + count * 4 * (e - ep)) / 0.012;
      raw = 60 * e + Ip + d;
      next = q12 * floor (max (-50, min (50, raw)) / q12 + 0.5);
      draw = (100 * 0.3)^2 / ((100 * 0.3)^2 + (60 / 100)^2);
      Ip += 100 * 0.002 * e + draw * 0.002 / 0.3 * (next - raw);
      ep = e;
    end
    cart = half(1:3,:) * [cart; held];
    held = next;
    cart = half(1:3,:) * [cart; held];
    h = 1e-3 / 20;
    for j = 1:20
      k1 = fall (arm, u);
      k2 = fall (arm + h / 2 * k1, u);
      k3 = fall (arm + h / 2 * k2, u);
      k4 = fall (arm + h * k3, u);
      arm += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    end
    count = 1;
  end
  wanted(end,:) = [arm(1), cart(1), arm(2), cart(2), cart(3)];
  ## Runge-Kutta's steps of 0.05 ms: 1e-13; the states move by up to 0.5 rad and 1.5 V
  gsmbp_check (["sampled controllers, encoder, converters, delay: against their difference " ...
                "equations"], (found - wanted) ./ max (abs (wanted)), 1e-9);
  gsmbp_check ("sampled controllers: what is commanded is reached", ...
               found(end,[1, 5]) ./ [0.5, 1.5] - 1, 0.1);
end

## a rotor as a body that a motion turns, and as a constant angular momentum
function gyroscope ()
  m = gsmbp_fixture ("mech_gyroscope");
  x0 = zeros (10, 1);
  x0(8) = m.par.w;
  t = linspace (0, 2, 21);
  r = gsmbp_simulate (m, x0, t, "rtol", 1e-11, "atol", 1e-12);
  gsmbp_check ("gyroscope: precession and nutation as those of a body, rad", ...
               r.x(:,1:2) - r.x(:,4:5), 1e-9);
  y = m.out (2, r.x(end,:)', []);
  gsmbp_check ("gyroscope: reaction as that of a body, relative", ...
               (y(1:6) - y(7:12)) / norm (y(1:6)), 1e-9);
end

## the command for a planned motion, then the motion under that command
function forward_after_inverse (what, m, plan)
  t = linspace (plan.breaks(1), plan.breaks(end), 21);
  r = gsmbp_inverse (m, plan, t(1));
  gsmbp_check ([what ": margins"], isempty (r.violations));
  tol = 1e-9;
  f = gsmbp_simulate (m, r.x', t, "motion", plan, "rtol", tol, "atol", tol);
  gsmbp_check ([what ": motion after its command, coordinates"], ...
               f.x(:,1:m.sizes.nq) - gsmbp_evaluate (plan, t)', 10 * tol);
end

## right-hand side and Jacobian are finite
function finite (what, m, x, v)
  A = m.jac (0, x, v);
  gsmbp_check ([what ": finite"], all (isfinite (m.rhs (0, x, v))) && all (isfinite (A(:))));
end

## energy less what went in and out, of all that passed; powers are integrated with the states
function audit (what, m, x0, duration, v)
  r = gsmbp_simulate (m, x0, [0, duration], "input", v, "rtol", 1e-10, "atol", 1e-12, "audit", 1);
  printf ("%s: %.3g J passed\n", what, r.audit.passed(end));
  gsmbp_check ([what ": energy audit"], r.audit.error, 1e-8);
end
