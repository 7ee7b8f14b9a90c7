## The scenes of the examples hooke, lead_screw, spinning_top and rolling_disc against closed forms
## and equations written down apart from the package.

function test_examples_joints ()
  hooke (example_model ("hooke"), beside ("hooke", "hooke_double"));
  lead_screw (example_model ("lead_screw"));
  spinning_top (example_model ("spinning_top"));
  rolling_disc (example_model ("rolling_disc"), beside ("rolling_disc", "rolling_disc_angles"));
end

## the model of a further scene in the folder of an example
function m = beside (folder, name)
  out = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  if (! exist (fullfile (out, [name ".f"]), "file"))
    gsmbp_derive (fullfile (fileparts (mfilename ("fullpath")), "..", "..", "examples", folder, ...
                            [name ".mac"]), out);
  end
  m = gsmbp_build (name, "directory", out);
end

function hooke (m, two)
  ## with d the direction of the driven shaft and c that of the cross in the driver, the joint
  ## passes on a moment along d - (d.c) c
  omega = 7;
  for theta = [0.3 1.9 4.4]
    b = theta / 6;
    k = gsmbp_set (m, "b", b);
    x = gsmbp_assemble (k, [theta; atan2(cos (b) * sin (theta), cos (theta)); omega; 0; 3], ...
                        "hold", "theta");
    ratio = cos (b) / (1 - sin (theta) ^ 2 * sin (b) ^ 2);
    gsmbp_check (sprintf ("hooke: ratio of the speeds, shafts at %.2f rad", b), ...
                 x(4) / omega - ratio, 1e-13);
    xd = k.rhs (0, x, 0);
    y = k.out (0, x, 0);
    p = k.par;
    torque = p.j2 * xd(4) + p.c * x(4) + p.tl;
    drive = p.n * p.km * 3 - p.n ^ 2 * p.bm * omega - (p.j1 + p.n ^ 2 * p.jm) * xd(3);
    bent = [tan(b) * cos(theta), sin(b) * sin(theta) / sqrt(1 - sin (theta) ^ 2 * sin (b) ^ 2)];
    gsmbp_check ("hooke: moments on driver and driven shaft, along and across, N m", ...
                 y - [drive; drive * bent(1); torque; torque * bent(2)], 1e-12);
    gsmbp_check ("hooke: the massless cross loses no power", drive * omega - torque * x(4), ...
                 1e-12 * abs (torque * x(4)) + 1e-12);
  end
  ## tan (psi) = gain * tan (theta)
  for mount = [pi/6, pi/6, 0, 1; pi/6, -pi/6, 0, 1; pi/6, pi/12, 0, cos(pi/6)/cos(pi/12); pi/6, ...
               pi/6, pi/2, cos(pi/6)^2]'
    k = gsmbp_set (two, "b1", mount(1), "b2", mount(2), "w", mount(3));
    t = 0:0.02:0.3;
    x = gsmbp_run (k, t, gsmbp_assemble (k, [0 0 0 0 20 0 0 0], "hold", "theta"), []);
    wanted = mount(4) ./ (cos (20 * t) .^ 2 + mount(4) ^ 2 * sin (20 * t) .^ 2);
    gsmbp_check (sprintf ("hooke_double: ratio, bends %.2f and %.2f rad, fork turned by %.2f", ...
                          mount(1:3)), x(:,8)' / 20 - wanted, 1e-12);
  end
end

function lead_screw (m)
  ## without dry friction it is linear: angle, speed, current; the matrix exponential
  k = gsmbp_set (m, "mu", 0, "lead", 0.02, "f", 40);
  p = k.par;
  h = p.lead / (2 * pi);
  J = p.js + p.n ^ 2 * p.jm + p.mt * h ^ 2;
  B = p.cb + p.n ^ 2 * p.bm + p.cg * h ^ 2;
  A = [0, 1, 0; 0, -B / J, p.n * p.km / J; 0, -p.n * p.km / p.la, -p.ra / p.la];
  push = [0; -h * (p.mt * p.g + p.f) / J; 30 / p.la];
  T = 2;
  z = expm ([A, push; zeros(1, 4)] * T)(1:3,4);
  r = gsmbp_simulate (k, zeros (5, 1), [0 T], "input", 30, "rtol", 1e-13);
  ## tolerance: 1e-13 a step, some hundred steps
  gsmbp_check ("lead_screw: angle, speed, current after 2 s on 30 V", ...
               r.x(end,[1 3 5])' ./ z - 1, 1e-10);
  gsmbp_check ("lead_screw: the table follows the turns", ...
               r.x(end,[2 4]) ./ (h * r.x(end,[1 3])) - 1, 1e-13);
  xd = k.rhs (0, r.x(end,:)', 30);
  y = k.out (0, r.x(end,:)', 30);
  force = p.mt * (p.g + xd(4)) + p.cg * r.x(end,4) + p.f;
  gsmbp_check ("lead_screw: force in the thread", y(strcmp (k.outputs, "thread.z")) / force - 1, ...
               1e-12);
  sys = gsmbp_linear (k, 0, r.x(end,:)', 30, "reduced", "theta");
  gsmbp_check ("lead_screw: reduced linear model", (sys.a - A) / max (abs (A(:))), 1e-12);
  turns = 1e4;
  phi = k.con (0, [2 * pi * turns; turns * p.lead]);
  gsmbp_check ("lead_screw: 10 000 turns are not mistaken for none, m", phi, 1e-12);
end

function spinning_top (m)
  ## cos (nutation) swings between two roots of a cubic in a time that is an elliptic integral
  p = m.par;
  I = p.i1 + p.m * p.l ^ 2;
  mgl = p.m * p.g * p.l;
  for rate = [-6 0 2.5]
    L3 = p.i3 * 250;
    Lz = I * rate * sin (0.5) ^ 2 + L3 * cos (0.5);
    E = I * (rate * sin (0.5)) ^ 2 / 2 + mgl * cos (0.5);
    u = sort (roots (conv ([-1 0 1], [-2*mgl, 2*E] / I) - [0, conv([-L3, Lz], [-L3, Lz])] / I ^ 2));
    period = 4 * ellipke ((u(2) - u(1)) / (u(3) - u(1))) / sqrt (2 * mgl / I * (u(3) - u(1)));
    x0 = [cos(0.25); sin(0.25); 0; 0; 0; rate * sin(0.5); 250];
    x = gsmbp_run (m, (0:4) * period / 2, x0, []);
    for k = 1:5
      y = m.out (0, x(k,:)');
      height(k) = y(3);
      moment(k,:) = y(strncmp (m.outputs, "support.m", 9));
    end
    ## half a period apart it stands in turn at both limits; there the error of time counts in
    ## second order alone
    gsmbp_check (sprintf (["spinning_top: limits of nutation in the period of the closed form, " ...
                           "released at %g rad/s"], rate), height - u([2 1 2 1 2])', 1e-11);
    gsmbp_check ("spinning_top: the point carries no moment, N m", moment, 1e-13);
  end
end

function rolling_disc (m, angles)
  p = m.par;
  I = p.m * p.r ^ 2 * [1/4, 1/2, 1/4];
  for lean = [0.2 0.9 1.3]
    ## a state: turned by 1 about z, then by lean about x; any angular velocity
    e = [cos(0.5) * cos(lean / 2); cos(0.5) * sin(lean / 2); sin(0.5) * sin(lean / 2); ...
         sin(0.5) * cos(lean / 2)];
    w = [3; -7; 2] * (1 + lean);
    [wd, F, R, c] = newton_euler (p, I, e, w);
    x = [0.1; -0.2; c(3); e; R * cross(w, R' * c); w];
    [phi, phit, H] = m.con (0, x(1:7), x(8:13));
    gsmbp_check ("rolling_disc: a state that rolls fulfils the constraints", ...
                 [phi; H * x(8:13) + phit], 1e-14);
    [ud, lam] = m.acc (0, x);
    gsmbp_check (sprintf ("rolling_disc: angular acceleration, leaning by %.1f", lean), ...
                 (ud(4:6) - wd) / norm (wd), 1e-12);
    gsmbp_check ("rolling_disc: normal force and friction", ...
                 [lam(1) - F(3); norm(lam(2:3)) - norm(F(1:2))] / norm (F), 1e-12);
  end
  ## upright at a rate w: leaning grows or swings with s^2 = 4/5 (g/r - 3 w^2)
  for w = [0.7 1.6] * sqrt (p.g / (3 * p.r))
    x = gsmbp_assemble (angles, [0; 0; p.r; 0; 0; 0; w * p.r; 0; 0; 0; 0; w]);
    poles = eig (gsmbp_linear (angles, 0, x).a);
    s = poles(abs (poles) > 1e-3);
    gsmbp_check (sprintf ("rolling_disc_angles: poles upright at %.2f rad/s", w), ...
                 sort (real (s .^ 2)) / (0.8 * (p.g / p.r - 3 * w ^ 2)) - 1, 1e-9);
  end
end

## Newton and Euler of a disc that touches the plane z = 0 below its centre c (above the point of
## contact); E Euler parameters, W angular velocity in its axes. Nine linear equations: angular
## acceleration (of the disc, its axes), acceleration of the centre, force of the plane (ground
## axes).
function [wd, F, R, c] = newton_euler (p, I, e, w)
  v = e(2:4);
  hat = @(a) [0, -a(3), a(2); a(3), 0, -a(1); -a(2), a(1), 0];
  R = (2 * e(1) ^ 2 - 1) * eye (3) + 2 * (v * v') + 2 * e(1) * hat (v);
  a = R(:,2);
  W = R * w;
  J = R * diag (I) * R';
  u = [0; 0; 1] - a(3) * a;
  up = u / norm (u);
  c = p.r * up;
  ad = cross (W, a);
  ud = -ad(3) * a - a(3) * ad;
  cd = p.r * (ud - (up' * ud) * up) / norm (u);
  O = zeros (3);
  A = [J, O, hat(c); hat(c), eye(3), O; O, p.m * eye(3), -eye(3)];
  z = A \ [-cross(W, J * W); cross(W, cd); 0; 0; -p.m * p.g];
  wd = R' * z(1:3);
  F = z(7:9);
end
