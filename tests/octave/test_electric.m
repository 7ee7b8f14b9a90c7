## The electric entries in scenes: start of an induction motor against an independent solution;
## energy; exact Jacobians; inverse, then forward; hazards.

function test_electric ()
  warning ("off", "gsmbp:stiff", "local");   # steps of the amplifiers' lags, 0.1 ms, on purpose
  start = gsmbp_fixture ("electric_start");
  against_currents (start);
  frames (start);
  hazards (start);
  limits ();
  rand ("twister", 6);
  for name = {"electric_arms", "electric_reduced", "electric_others"}
    m = gsmbp_fixture (name{1});
    jacobians (name{1}, m);
    back_and_forth (name{1}, m);
  end
end

## Start of Krause's 3 hp motor on 220 V, 60 Hz. Independent: complex currents in the frame of the
## stator (the model has flux linkages in that of the supply), fixed steps of Gragg's extrapolation
## (the model's integrator is Dormand and Prince's). Fluxes come from the currents at the end.
function against_currents (m)
  t = 0:0.05:0.5;
  V = 220 * sqrt (2/3);
  r = gsmbp_simulate (m, zeros (6, 1), t, "input", [V; 0; 377], "rtol", 1e-11);
  p = m.par;
  Ls = p.motor_Lls + p.motor_Lm;
  Lr = p.motor_Llr + p.motor_Lm;
  L = [Ls, p.motor_Lm; p.motor_Lm, Lr];
  LI = inv (L);
  k = 1.5 * p.motor_np * p.motor_Lm / (p.motor_J + p.jw);
  motion = @(t, x) [LI ...
      * [V * exp(377i*t) - p.motor_Rs * x(1); ...
         1i * p.motor_np * x(3) * (Lr * x(2) + p.motor_Lm * x(1)) - p.motor_Rr * x(2)]; ...
                    k * imag(x(1) * conj (x(2)))];
  y = gragg (motion, t, 5e-3, 10, [0; 0; 0]);
  flux = (L * y(1:2,:)) .* exp (-377i * t);
  wanted = [real(flux(1,:)); imag(flux(1,:)); real(flux(2,:)); imag(flux(2,:))]';
  gsmbp_check (["electric_start: speed of shaft / 188.5 rad/s against the independent " ...
                "solution"], (r.x(:,2) - real (y(3,:))') / 188.5, 1e-8);
  gsmbp_check ("electric_start: flux linkages / 0.5 Wb against the independent solution", ...
               (r.x(:,3:6) - wanted) / 0.5, 1e-8);
  torque = arrayfun (@(i) m.out (t(i), r.x(i,:)', [V; 0; 377]), 1:numel (t))';
  gsmbp_check ("electric_start: torque / 100 N m", ...
               (torque - 1.5 * p.motor_np * p.motor_Lm * imag (y(1,:) .* conj (y(2,:)))') / 100, ...
               1e-8);
  audit ("electric_start", m, zeros (6, 1), linspace (0, 0.5, 301), [V; 0; 377], 1e-8);
end

## The same start with the frame at rest: the voltage turns instead; the speed is the same, the
## steps of a running motor are smaller.
function frames (m)
  V = 220 * sqrt (2/3);
  t = [0, 0.5, 1];
  [turning, rested] = deal (gsmbp_simulate (m, zeros (6, 1), t, "input", [V; 0; 377]), ...
                            gsmbp_simulate (m, zeros (6, 1), t, "input", ...
                                @(t, x) [V * cos(377*t); V * sin(377*t); 0]));
  gsmbp_check ("electric_start: speed does not depend on the frame", ...
               (turning.x(:,2) - rested.x(:,2)) / 188.5, 1e-8);
  printf (["   calls of the right-hand side: %d in the frame of the supply, %d in " ...
           "that of the stator\n"], turning.stats.calls, rested.stats.calls);
end

## Nothing divides by what may vanish: no flux, no speed, no voltage, frame at rest.
function hazards (m)
  gsmbp_check ("electric_start: unmagnetised at standstill, no supply: nothing moves", ...
               m.rhs (0, zeros (6, 1), zeros (3, 1)), 0);
  xd = m.rhs (0, zeros (6, 1), [180; 0; 377]);
  gsmbp_check (["electric_start: unmagnetised at standstill, supply on: flux grows with " ...
                "the voltage"], xd - [0; 0; 180; 0; 0; 0], 0);
  m = gsmbp_fixture ("electric_arms");
  x = zeros (m.sizes.nx, 1);
  finite = [];
  for size = [0, 1e-300, 1e3, 1e6]
    finite(end+1) = all (isfinite (m.rhs (0, x + size, size * ones (m.sizes.nv, 1))));
  end
  gsmbp_check ("electric_arms: rates are finite from rest to 1e6 units", finite);
  ## through zero current and zero speed: voltage of the brushes and Coulomb friction change sign
  ## smoothly and monotonically
  i = find (strcmp (m.states, "dc.i"));
  w = find (strcmp (m.states, "q4_d"));
  sweep = @(k, top, row) arrayfun (@(z) m.rhs (0, x + z * ((1:m.sizes.nx)' == k), ...
                                     zeros (m.sizes.nv, 1))(row), linspace (-top, top, 201));
  gsmbp_check ("electric_arms: brushes, from -0.4 to 0.4 A", diff (sweep (i, 0.4, i)) < 0);
  gsmbp_check ("electric_arms: Coulomb friction, from -5 to 5 rad/s", diff (sweep (w, 5, w)) < 0);
end

## An amplifier that cannot give the voltage, a stepping motor that cannot hold the load: the first
## time is reported, and it is the right one.
function limits ()
  t = 0:0.02:1;
  m = gsmbp_fixture ("electric_arms");
  r = gsmbp_inverse (m, plan_of (m), t);
  ## the voltage before the amplifier's lag
  v = r.x(:,strcmp (m.states, "va.x"));
  asked = v + m.par.va_ta * gradient (v, 0.02);
  limited = gsmbp_inverse (gsmbp_set (m, "va_Vm", 5), plan_of (m), t).violations;
  gsmbp_check ("electric_arms: time when 5 V is not enough", ...
               limited.time - t(find (abs (asked) >= 5, 1)), 0);
  m = gsmbp_fixture ("electric_reduced");
  r = gsmbp_inverse (m, plan_of (m), t);
  effort = 1.2 * sin (4 * (r.v(:,strcmp (m.inputs, "sp.sc")) - r.q(:,3)));   # Km*Ip, Nr
  limited = gsmbp_inverse (gsmbp_set (m, "sp_Ip", 0.2), plan_of (m), t).violations;
  gsmbp_check ("electric_reduced: time when 0.2 A does not hold the load", ...
               limited.time - t(find (abs (effort) >= 0.2 * 0.6, 1)), 0);
end

## all the arms from rest to rest in 1 s
function plan = plan_of (m)
  plan = gsmbp_plan ("septic", ...
                     [zeros(m.sizes.nu, 1), ...
                      [0.6; -0.5; 0.8; 0.7; -0.6; 0.5; -0.4](1:m.sizes.nu)], [0 1]);
end

## Exact Jacobians against central differences of fourth order, with states and inputs of the size
## of their nominal values
function jacobians (name, m)
  d = m.sizes;
  x = [2 * rand(2 * d.nu, 1) - 1; (2 * rand(d.nx - 2 * d.nu, 1) - 1) * 0.5];
  v = 2 * rand (d.nv, 1) - 1;
  [A, B] = m.jac (0, x, v);
  J = differences (@(z) m.rhs (0, z(1:d.nx), z(d.nx+1:end)), [x; v]);
  ## rates of 1e5 A/s, rounded, over 2e-5
  gsmbp_check ([name ": exact Jacobians against differences"], ...
               ([A, B] - J) ./ max (1, max (abs ([A, B]), [], 2)), 1e-8);
end

function J = differences (f, z)
  for k = 1:numel (z)
    h = 2e-5 * ((1:numel (z))' == k);   # a brush drop bends within 0.04 A
    J(:,k) = (8 * (f (z + h) - f (z - h)) - f (z + 2 * h) + f (z - 2 * h)) / 24e-5;
  end
end

## Energy along a run from x on the instants t: Gauss' rule of five points between them; error
## beside the energy that has gone in or was lost. E = kinetic + potential + stored.
function audit (name, m, x, t, input, tolerance)
  [node, weight] = gauss ();
  h = diff (t);
  at = unique ([t, (t(1:end-1) + h .* node)(:)']);
  if (isstruct (input))
    r = gsmbp_simulate (m, x, at, "motion", input, "rtol", 1e-12);
  else
    r = gsmbp_simulate (m, x, at, "input", input, "rtol", 1e-12);
  end
  e = cell2mat (arrayfun (@(i) m.ene (at(i), r.x(i,:)', r.v(i,:)')(:), 1:numel (at), ...
                          "UniformOutput", false));
  inner = ! ismember (at, t);
  gone = @(p) sum (h .* (weight' * reshape (p(inner), numel (node), [])));
  E = sum (e(1:3,:));
  passed = gone (abs (e(4,:))) + gone (e(5,:));
  gsmbp_check ([name ": energy audit"], ...
               (E(end) - E(1) - gone (e(4,:)) + gone (e(5,:))) / passed, tolerance);
  gsmbp_check ([name ": nothing negative is lost"], e(5,:) >= 0);
end

function [node, weight] = gauss ()
  [V, D] = eig (diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), 1) ...
                  + diag ((1:4) ./ sqrt (4 * (1:4) .^ 2 - 1), -1));
  node = (1 + diag (D)) / 2;
  weight = V(1,:)' .^ 2;
end

## The inputs that the inverse gives drive the model forward. The amplifiers ask for the fourth
## derivative of the motion, which jumps at the ends of a septic: the states start on the motion all
## the same.
function back_and_forth (name, m)
  d = m.sizes;
  plan = plan_of (m);
  t = 0:0.1:1;
  r = gsmbp_inverse (m, plan, t);
  back = gsmbp_simulate (m, r.x(1,:)', t, "motion", plan, "rtol", 1e-9);
  gsmbp_check ([name ": inverse, then forward: coordinates"], back.x(:,1:d.nq) - r.q, 1e-8);
  gsmbp_check ([name ": inverse, then forward: all states"], ...
               (back.x - r.x) ./ m.json.nominal(:)', 1e-8);
  ## no_stator closes its balance to first order in 1/wk only (rtest_electric)
  audit (name, m, r.x(1,:)', linspace (0, 1, 401), plan, ...
         merge (strcmp (name, "electric_reduced"), 1e-4, 1e-8));
end
