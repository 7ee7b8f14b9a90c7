## The scenes and plans of the examples welding_arm and scara: the arm against its URDF, read anew,
## and Newton's and Euler's equations of that; the seams against lines, circles and turns; voltages
## and margins; the SCARA against formulas by hand.

function test_examples_robots ()
  root = fullfile (fileparts (mfilename ("fullpath")), "..", "..", "examples");
  addpath (fullfile (root, "..", "tests", "octave", "independent"));
  for name = {"welding_arm", "scara"}
    addpath (fullfile (root, name{1}));
  end
  arm = read_urdf (fullfile (root, "welding_arm", "welding_arm.urdf"));
  m = example_model ("welding_arm");
  gsmbp_check ("welding arm: limits of the scene are those of the URDF", ...
               [cat(1, m.json.limits.low), cat(1, m.json.limits.high)] - arm.limits, 0);
  limited (m);
  p = welding_plan (m, 0.35);
  seams (arm, p);
  voltages (arm, m, p);
  margins (m);
  scara (example_model ("scara"));
end

## joints from the base on (at: 3 x 8, turns of their places, axes: 0 where fixed) and what each
## carries
function arm = read_urdf (file)
  text = fileread (file);
  pieces = regexp (text, '<joint name.*?</joint>', 'match');
  number = @(s, word) str2num (regexp (s, [word '="([^"]*)"'], 'tokens', 'once'){1});
  part = @(s, word) regexp (s, ['<' word '[^>]*>'], 'match', 'once');
  for k = 1:numel (pieces)
    joint = pieces{k};
    arm.at(:,k) = number (part (joint, "origin"), "xyz");
    arm.rpy(:,k) = number (part (joint, "origin"), "rpy");
    arm.axis(:,k) = [0; 0; 0];
    if (! isempty (part (joint, "axis")))
      arm.axis(:,k) = number (part (joint, "axis"), "xyz");
      arm.limits(k,:) = [number(joint, "lower"), number(joint, "upper")];
      arm.damping(k) = number (joint, "damping");
      arm.dry(k) = number (joint, "friction");
    end
    child = regexp (joint, 'child link="([^"]*)"', 'tokens', 'once'){1};
    link = regexp (text, ['<link name="' child '">.*?</link>'], 'match', 'once');
    [arm.mass(k), arm.centre(:,k), arm.J(:,k)] = deal (0, [0; 0; 0], [0; 0; 0]);
    if (! isempty (link))
      arm.mass(k) = number (part (link, "mass"), "value");
      arm.centre(:,k) = number (part (link, "origin"), "xyz");
      arm.J(:,k) = [number(link, "ixx"), number(link, "iyy"), number(link, "izz")];
    end
  end
end

## axes of the bodies in ground axes, places of their joints
function [R, P] = poses (arm, q)
  [A, x] = deal (eye (3), zeros (3, 1));
  q(end+1:numel (arm.mass)) = 0;
  for k = 1:numel (arm.mass)
    x += A * arm.at(:,k);
    A *= ne_turn ([0; 1; 0], arm.rpy(2,k)) * ne_turn (arm.axis(:,k), q(k));
    [R(:,:,k), P(:,k)] = deal (A, x);
  end
end

## a wrist bent beyond its limit: both wrists are out, and without limits the pose is reached
function limited (m)
  q = [0.2; 0.1; -0.3; 0.4; 2.5; -0.6];
  [P, R] = m.pnt (0, q);
  [~, told] = gsmbp_reach (m, "wire", P, R, "start", q);
  gsmbp_check ("welding arm: beyond the limits of its scene", strcmp (told.status, "limits"));
  [found, told] = gsmbp_reach (m, "wire", P, R, "start", q, "limits", repmat ([-10, 10], 6, 1));
  gsmbp_check ("welding arm: within other limits", strcmp (told.status, "ok"));
  gsmbp_check ("welding arm: the angles of the pose, rad", found - q, 1e-12);
end

## the wire along the seams
function seams (arm, p)
  for k = 1:2
    on = find (p.t >= p.seams(k).times(1) - 1e-9 & p.t <= p.seams(k).times(2) + 1e-9);
    for i = 1:numel (on)
      [R, P] = poses (arm, p.q(on(i),:)');
      [x{k}(:,i), w{k}(:,i), along{k}(:,i)] = deal (P(:,end), R(:,3,end), R(:,1,end));
    end
  end
  gsmbp_check ("straight seam: on the line, m", [x{1}(1,:) - 0.6, x{1}(3,:) - 0.4], 1e-14);
  gsmbp_check ("straight seam: from end to end, m", x{1}(2,[1, end]) - [-0.25, 0.25], 1e-14);
  lean = 0.25 * (1 - 2 * (x{1}(2,:) + 0.25) / 0.5);   # in proportion to the way
  gsmbp_check ("straight seam: direction of the wire", ...
               w{1} - [0 * lean; sin(lean); -cos(lean)], 1e-13);
  out = x{2} - [0.6; 0; 0.4];
  gsmbp_check ("round the tube: radius and height, m", [norm(out(1:2,:), "columns") - 0.12, ...
                                                       out(3,:)], 1e-14);
  phi = atan2 (-out(2,:), -out(1,:));
  gsmbp_check ("round the tube: from -80 to 80 degrees", phi([1, end]) - [-1, 1] * 4*pi/9, 1e-13);
  gsmbp_check ("round the tube: the wire leans outwards by 0.45", ...
               w{2} + [sin(0.45) * cos(phi); sin(0.45) * sin(phi); cos(0.45) + 0 * phi], 1e-13);
  gsmbp_check ("round the tube: and turns with the way", ...
               along{2}(3,:) - sin (0.45), 1e-13);
end

## efforts by Newton and Euler for the bodies of the URDF with the feeder, voltages by the motors'
## equations, at the middle of some pieces of the plan
function voltages (arm, m, p)
  h = 1e-4;
  r = gsmbp_inverse (m, p.motion, (p.t(3:29:end-1) + 0.0025 + h * [-1; 0; 1])(:));
  gear = [160; 160; 140; 90; 90; 70];
  motor = [1; 1; 1; 2; 2; 2];
  rotor = gear .^ 2 .* [1.2e-4; 1.5e-5](motor);
  loss = gear .^ 2 .* [2e-4; 3e-5](motor);
  for k = 1:numel (r.t)
    tau(k,:) = newton_euler (arm, m.par.mf, r.q(k,:)', r.u(k,:)', r.ud(k,:)') ...
               + (rotor .* r.ud(k,:)' + (loss + arm.damping(1:6)') .* r.u(k,:)' ...
                  + arm.dry(1:6)' .* tanh (r.u(k,:)' / 1e-4))';
  end
  gsmbp_check ("welding arm: efforts by Newton and Euler for its URDF, N*m", tau - r.tau, 1e-11);
  [K, R, L] = deal ([0.11; 0.05](motor)', [0.35; 1.1](motor)', [6e-4; 8e-4](motor)');
  current = tau ./ (gear' .* K);
  gsmbp_check ("welding arm: currents, A", current - r.x(:,13:18), 1e-11);
  rate = (current(3:3:end,:) - current(1:3:end,:)) / (2 * h);
  turns = abs (r.u(2:3:end,:)) < 0.01;   # where friction changes its sign within h
  volts = R .* current(2:3:end,:) + K .* gear' .* r.u(2:3:end,:) + L .* rate;
  gsmbp_check ("welding arm: instants compared", mean (! turns(:)) > 0.6);
  gsmbp_check ("welding arm: voltages by the motors' equations, V", ...
               (volts - r.y(2:3:end,:))(! turns), 1e-6);
end

## efforts at the six joints from the force and moment on everything behind each
function tau = newton_euler (arm, feeder, q, u, ud)
  [R, P] = poses (arm, q);
  [w, al, a, before] = deal (zeros (3, 1), zeros (3, 1), [0; 0; 9.81], zeros (3, 1));
  u(end+1:numel (arm.mass)) = ud(end+1:numel (arm.mass)) = 0;
  for k = 1:numel (arm.mass)
    a += cross (al, P(:,k) - before) + cross (w, cross (w, P(:,k) - before));
    before = P(:,k);
    e = R(:,:,k) * arm.axis(:,k);   # the joint's axis does not move by the joint
    al += e * ud(k) + cross (w, e * u(k));
    w += e * u(k);
    J = R(:,:,k) * diag (arm.J(:,k)) * R(:,:,k)';
    c = R(:,:,k) * arm.centre(:,k);
    at = @(d) a + cross (al, d) + cross (w, cross (w, d));
    F = arm.mass(k) * at (c);
    f(:,k) = F;
    n(:,k) = J * al + cross (w, J * w) + cross (P(:,k) + c, F);   # about the origin
    if (k == 3)
      d = R(:,:,k) * [-0.05; 0; 0.12];
      f(:,k) += feeder * at (d);
      n(:,k) += cross (P(:,k) + d, feeder * at (d));
    end
  end
  for k = 1:6
    [F, N] = deal (sum (f(:,k:end), 2), sum (n(:,k:end), 2));
    tau(k) = dot (R(:,:,k) * arm.axis(:,k), N - cross (P(:,k), F));
  end
end

## at 0.5 m/s the first motor asks for more than its supply gives, from the instant that is told
function margins (m)
  p = welding_plan (m, 0.5);
  t = p.t(2:2:end-1);
  needed = gsmbp_inverse (gsmbp_set (m, "us", 1e4), p.motion, t).y;
  told = gsmbp_inverse (m, p.motion, t).violations;
  gsmbp_check ("welding arm at 0.5 m/s: one margin is broken, that of motor 1", ...
               numel (told) == 1 && strncmp (told.text, "amplifier_1:", 12));
  gsmbp_check ("welding arm at 0.5 m/s: the instant, s", ...
               told.time - t(find (abs (needed(:,1)) >= m.par.us, 1)), 0);
  gsmbp_check ("welding arm at 0.5 m/s: least margin", ...
               told.least - (1 - (max (abs (needed(:,1))) / m.par.us) ^ 2), 1e-8);
end

## both elbows, the double S, the arch in the least time
function scara (m)
  for branch = 1:2
    [path, q] = scara_gate (m, branch);
    [at, angle] = scara_hand (m.par, q);
    gsmbp_check (sprintf ("SCARA, branch %d: corners, m", branch), ...
                 at - [0.36 0.36 0.05 0.05; -0.22 -0.22 0.44 0.44; 0.08 0.16 0.16 0.08], 1e-14);
    gsmbp_check (sprintf ("SCARA, branch %d: angles of the hand", branch), ...
                 exp (1i * angle) - exp (1i * [0 0 pi/2 pi/2]), 1e-14);
    gsmbp_check (sprintf ("SCARA, branch %d: elbow", branch), ...
                 all (sign (q(2,:)) == 3 - 2 * branch));
    motion = scara_cycle (q);
    t = linspace (0, motion.breaks(end), 203)(2:end-1);
    r = gsmbp_inverse (m, motion, t, "quasistatic", true);
    [~, ~, tau, v] = scara_hand (m.par, r.q', r.u', r.ud');
    gsmbp_check (sprintf ("SCARA, branch %d: efforts by hand, N*m", branch), tau' - r.tau, 1e-12);
    gsmbp_check (sprintf ("SCARA, branch %d: voltages by hand, V", branch), v' - r.v, 1e-12);
    gsmbp_check (sprintf ("SCARA, branch %d: within 24 V with inductance", branch), ...
                 gsmbp_inverse (m, motion, t).v, 24);
  end
  [quick, told] = gsmbp_retime (m, path, "input", 23, "points", 60, "rtol", 1e-2);
  f = gsmbp_evaluate (quick, linspace (0, told.T, 400)(2:end-1), 2);
  [at, ~, ~, v] = scara_hand (m.par, f(:,:,1), f(:,:,2), f(:,:,3));
  gsmbp_check ("SCARA, least time: in the plane of the arch, m", ...
               [0.66, 0.31] * (at(1:2,:) - [0.36; -0.22]), 2e-5);
  gsmbp_check ("SCARA, least time: voltages between the points, V", v, 1.2 * 23);
  gsmbp_check ("SCARA, least time: one of them near its limit", ...
               mean (any (abs (v) > 0.9 * 23, 1)) > 0.8);
  gsmbp_check ("SCARA, least time: less than the double S", told.T < 0.7 * motion.breaks(end-1));
end
