## Points behind every kind of joint: places and axes from products of transformations written here,
## Jacobians and (dJ/dt) u from differences of eighth order of these along the motion, functions of
## points in outputs from the handles.

function test_points_motion ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "independent"));
  m = gsmbp_fixture ("points_joints");
  randn ("seed", 5);
  worst = zeros (1, 6);
  for k = 1:6
    q = randn (m.sizes.nq, 1);
    set = m.orientation;
    q(set) /= norm (q(set));
    u = randn (m.sizes.nu, 1);
    worst = max (worst, [places(m, q), motion(m, q, u), outputs(m, q, u), parts(m, q, u)]);
  end
  names = {"places and axes", "J u against the rate of the place and axes", ...
           "dJu against the rate of J u", "functions of points in outputs", ...
           "the same: velocities and accelerations", "bias less gravity less Coriolis"};
  limits = [1e-14, 1e-11, 1e-11, 1e-13, 1e-12, 1e-13];
  for k = 1:numel (worst)
    gsmbp_check (["points behind every joint: " names{k}], worst(k), limits(k));
  end
end

function worst = places (m, q)
  [P, R] = m.pnt (0, q);
  worst = 0;
  T = by_hand (m, q);
  for k = 1:numel (m.points)
    H = T.(m.points{k});
    worst = max ([worst; abs(P(:,k) - H(1:3,4)); abs(R(:,3*k-2:3*k) - H(1:3,1:3))(:)]);
  end
end

## places of the points of the scene, 4 x 4, from its text
function T = by_hand (m, q)
  value = @(name) q(strcmp (m.coordinates, name));
  balls = q(m.orientation);
  T.base = move ([0.5, 0, 0.2]) * turn ("z", pi/6) * turn ("x", pi/2);
  T.mark = move ([1, 0, 0]);
  rod = T.base * move ([1, 2, 2] / 3 * value ("s1")) * move ([0.1, 0.2, 0]) ...
        * move ([0, value("s2"), 0]) * turn ("y", value ("q2"));
  cross_ = rod * move ([0, 0, 0.3]) * turn ("x", value ("q3")) * turn ("z", value ("q4")) ...
           * turn ("y", -pi/2);
  ball = cross_ * move ([0.2, 0, 0.1]) * turn ("z", pi/4) * whirl (balls) * turn ("x", -pi/6) ...
         * move ([0, 0.1, 0]);
  T.tip = ball * move ([0.3, 0.1, -0.2]);
  T.grip = cross_ * move ([0, 0, 0.1]) * turn ("z", pi/2);
  table = move ([value("x5"), value("y5"), 0]) * turn ("z", value ("q5"));
  nut = table * move ([0.05 * value("q6"), 0, 0]) * turn ("x", value ("q6"));
  bird = nut * move ([value("x7"), value("y7"), value("z7")]) * turn ("z", value ("q7")) ...
         * turn ("y", value ("q8")) * turn ("x", value ("q9"));
  T.tool = bird * move ([0.1, 0.2, 0.3]) * turn ("x", 40*pi/180) * turn ("y", 100*pi/180);
end

function T = move (r)
  T = [eye(3), r(:); 0, 0, 0, 1];
end

function T = turn (axis_, a)
  k = find ("xyz" == axis_);
  [i, j] = deal (mod (k, 3) + 1, mod (k + 1, 3) + 1);
  T = eye (4);
  T([i, j],[i, j]) = [cos(a), -sin(a); sin(a), cos(a)];
end

function T = whirl (e)
  v = e(2:4);
  S = [0, -v(3), v(2); v(3), 0, -v(1); -v(2), v(1), 0];
  T = blkdiag (eye (3) + 2*e(1)*S + 2*S*S, 1);
end

## [of J u, of dJu]
function worst = motion (m, q, u)
  n = m.sizes.nu;
  [J, dJu] = m.jpt (0, q, u);
  [~, R] = m.pnt (0, q);
  flow = @(h) along (m, q, u, h);
  worst = [0, 0];
  for k = 1:numel (m.points)
    block = @(J) J(:,n*(k-1)+1:n*k);
    V = block (J) * u;
    p = ne_difference (@(h) place (m, flow (h), k), 0.001);
    A = reshape (p(4:12), 3, 3) * R(:,3*k-2:3*k)';
    w = [A(3,2); A(1,3); A(2,1)];
    a = ne_difference (@(h) block (m.jpt (0, flow (h), u)) * u, 0.001);
    first = max (abs (V - [p(1:3); w])) / max ([abs(V); 1]);
    second = max (abs (dJu(:,k) - a)) / max ([abs(a); 1]);
    worst = max (worst, [first, second]);
  end
end

function x = place (m, q, k)
  [P, R] = m.pnt (0, q);
  x = [P(:,k); R(:,3*k-2:3*k)(:)];
end

## the coordinates after h, the speeds held, by the classical method in small steps
function q = along (m, q, u, h)
  steps = 8;
  h /= steps;
  for i = 1:steps
    a = m.kin (0, q, u);
    b = m.kin (0, q + h/2*a, u);
    c = m.kin (0, q + h/2*b, u);
    q += h/6 * (a + 2*b + 2*c + m.kin (0, q + h*c, u));
  end
end

## [of positions, of velocities and accelerations]
function worst = outputs (m, q, u)
  x = [q; u];
  ud = m.rhs (0, x)(m.sizes.nq+1:end);
  y = m.out (0, x);
  of = @(name) y(strncmp (m.outputs, [name "."], numel (name) + 1));
  one = @(name) y(strcmp (m.outputs, name));
  p = @(name, varargin) gsmbp_point (m, name, 0, q, u, ud, varargin{:});
  [tip, tool, grip] = deal (p ("tip"), p ("tool"), p ("grip"));
  mark = [1; 0; 0];
  same = @(e, f) min (norm (e - f), norm (e + f));
  [a, b] = deal (tip.position - mark, tool.position - mark);
  ## the axes of link cross are those of the frame grip turned back
  back = grip.rotation * [0, 1, 0; -1, 0, 0; 0, 0, 1];
  worst = zeros (1, 2);
  worst(1) = max ([same(of("e"), p("tool", "frame", "grip").euler_parameters), ...
                   same(of("g"), tip.euler_parameters), norm(of("rpy") - tool.roll_pitch_yaw), ...
                   abs(one("d") - norm(tip.position - tool.position)), ...
                   abs(one("c") - acos(a'*b/norm(a)/norm(b))), ...
                   norm(reshape(of("r"), 3, 3)' - back'*tool.rotation), ...
                   abs(one("h") - 2*tip.position(3) - 1)]);
  worst(2) = max ([norm(of("a") - tool.rotation'*tip.acceleration)/norm(of("a")), ...
                   norm(of("v") - tool.rotation'*tool.velocity), ...
                   norm(of("w") - grip.rotation'*tip.angular_velocity), ...
                   norm(of("al") - tool.angular_acceleration)/norm(of("al"))]);
end

function worst = parts (m, q, u)
  b = m.bia (0, q, u);
  worst = norm (b - m.gra (0, q) - m.cor (0, q, u)) / norm (b);
end
