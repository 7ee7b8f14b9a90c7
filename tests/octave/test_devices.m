## Devices on every kind of port: power balance at random states, mass matrix against kinetic
## energy, exact Jacobians, inverse and forward.

function test_devices ()
  m = gsmbp_fixture ("devices_ports");
  rand ("twister", 5);
  nx = m.sizes.nx;
  for k = 1:5
    x = m.initial ...
        + [0.4 * (rand (3, 1) - 0.5); 4 * (rand (3, 1) - 0.5); 3 * (rand (nx - 6, 1) - 0.5)];
    v = 10 * (rand (m.sizes.nv, 1) - 0.5);
    xd = m.rhs (0, x, v);
    e = m.ene (0, x, v);
    h = 1e-5;
    rate = sum (m.ene (0, x + h * xd, v)(1:3) - m.ene (0, x - h * xd, v)(1:3)) / (2 * h);
    balance(k) = (rate - e(4) + e(5)) / (abs (e(4)) + abs (e(5)));
    ## kinetic energy is u'Mu/2, so M holds the added masses of every port
    M = m.mas (0, x(1:3));
    kinetic(k) = x(4:6)' * M * x(4:6) / 2 / e(1) - 1;
    ## N is what M and the energy say (Lagrange): d/dt (M u) - dT/dq
    u = x(4:6);
    T = @(q) u' * m.mas (0, q) * u / 2;
    N = (m.mas (0, x(1:3) + h * u) - m.mas (0, x(1:3) - h * u)) / (2 * h) * u;
    for i = 1:3
      d = h * ((1:3)' == i);
      N(i) -= (T (x(1:3) + d) - T (x(1:3) - d)) / (2 * h);
    end
    given = m.bia (0, x(1:3), u, v) - m.bia (0, x(1:3), 0 * u, v);
    friction = (m.bia (0, x(1:3), u, v) - m.bia (0, x(1:3), -u, v)) / 2;   # odd in u
    lagrange(k) = norm (given - friction - N) / norm (N);
    [A, B] = m.jac (0, x, v);
    for j = 1:nx
      d = 1e-6 * max (1, abs (x(j))) * ((1:nx)' == j);
      D(:,j) = (m.rhs (0, x + d, v) - m.rhs (0, x - d, v)) / (2 * d(j));
    end
    jacobian(k) = norm (A - D) / norm (D);
  end
  gsmbp_check ("ports: power balance at random states", balance, 1e-8);
  gsmbp_check ("ports: kinetic energy", kinetic, 1e-12);
  gsmbp_check ("ports: N by Lagrange from M", lagrange, 1e-7);
  gsmbp_check ("ports: exact Jacobian against differences", jacobian, 1e-7);

  plan = gsmbp_plan ("septic", [m.initial(1:3), m.initial(1:3) + [0.3; -0.2; 0.4]], [0, 0.5]);
  t = (0:0.05:0.5)';
  r = gsmbp_inverse (m, plan, t);
  s = gsmbp_simulate (m, r.x(1,:)', t, "motion", plan, "rtol", 1e-10, "atol", 1e-12);
  gsmbp_check ("ports: forward after inverse [rad]", s.x(:,1:3) - r.q, 1e-9);
  gsmbp_check ("ports: states of the motors along the motion [A]", s.x(:,7:end) - r.x(:,7:end), ...
               1e-6);
  a = gsmbp_simulate (m, r.x(1,:)', t, "motion", plan, "rtol", 1e-10, "audit", 1);
  gsmbp_check ("ports: audit of the run's energy", a.audit.error, 1e-8);
  gsmbp_check ("ports: energy has passed", a.audit.passed(end) > 1);
  ## the two motors of joint C1 give two thirds and one third of its effort
  p = m.par;
  i_one = r.x(:,strcmp (m.states, "one.i"));
  u3 = r.u(:,3);
  torque_one = 20 * p.one_K * i_one;
  torque_two = 25 * p.two_K * (r.v(:,strcmp (m.inputs, "two.v")) - p.two_K * 25 * u3) / p.two_R;
  gsmbp_check ("ports: shares of two motors", torque_one ./ (torque_one + torque_two) - 2/3, 1e-12);
end
