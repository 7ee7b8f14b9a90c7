## m = random_scene (SEED, KIND, MOST): a mechanism made by chance, as data of the independent
## formulation (ne_*, world axes) and as the text of a scene.
##
## KIND: "tree": one to MOST links (default 6), branches, joints of all types; "loop": besides one
## to three loops, closed by construction near a position drawn by chance; "parallel": a ring whose
## axes are parallel (planar, or with screws along the axes), closed where all coordinates are zero;
## "spherical": a ring of revolutes whose axes meet in one point; both are overconstrained.
##
## Link and joint frames are turned by chance with quaternions of integers, so that every placement
## of the language is used with exact numbers; nothing of the scene's frames enters m. Fields beside
## those of ne_read: m.user {functions}, m.given, m.spring; m.name; m.q, m.u names of the
## coordinates and speeds of the tree joints; m.start a position that is closed; m.auto true if the
## scene leaves to GSMBP what to cut (m.loop_q, m.loop_u name the loop joints' coordinates then);
## m.text the scene. m.speeds (q, u): [A, A' u] of the scene's own speeds A u, m.u_own their names.

function m = random_scene (seed, kind, most)
  if (nargin < 3)
    most = 6;
  end
  types = {"revolute", "prismatic", "helical", "cylindrical", "universal", "spherical", ...
           "planar", "free", "fixed"};
  rand ("twister", 1000 * seed + sum (kind));
  m = struct ("name", sprintf ("%s_%d", kind, seed), "kind", kind, "gravity", decimals (3, ...
      10), "body", [], "joint", [], "loop", [], "user", {{}}, ...
              "given", [], "spring", [], "auto", false, "redundant", false, "elements", {{}}, ...
                  "turns", [], "origins", [], "loop_q", {{}}, ...
              "loop_u", {{}}, "cut_link", zeros (1, 0), "speeds", []);
  switch (kind)
    case "tree"
      m = bodies (m, randi (most));
      m = tree (m, types, 0.5);
    case "loop"
      m = bodies (m, randi ([2, most]));
      m = tree (m, types, 0.25);
    case {"parallel", "spherical"}
      m = closed_ring (m, most);
      m.redundant = strcmp (kind, "spherical");
  end
  m = names (m);
  if (any (strcmp (kind, {"tree", "loop"})))
    m.start = somewhere (m);
  end
  m.start_time = round (100 * rand) / 100;
  if (strcmp (kind, "loop"))
    m.auto = chance (0.3) && ! any (strcmp ({m.joint.type}, "free"));
    if (m.auto)
      [m.joint.named] = deal (false);
      m = names (m);
    end
    m = loops (m, [setdiff(types, "free"), repmat({"rolling"}, 1, ! m.auto)], randi (3));
    m = lilov (m);
  end
  m = efforts (m);
  m.u_own = m.u;
  if (! m.auto)
    m = laws (m);
    m = own_speeds (m);
  end
  m = massless (m);
  m = random_text (m);
end

## ----------------------------------------------------------------------------------------- numbers

function x = decimals (n, size)
  x = round (100 * size * (2 * rand (n, 1) - 1)) / 100;
end

function yes = chance (p)
  yes = rand < p;
end

function x = pick (list)
  x = list{randi (numel (list))};
end

## a quaternion of small integers, and its rotation
function w = quaternion ()
  w = [1, 0, 0, 0];
  if (chance (0.6))
    w = randi ([-2, 2], 1, 4);
    w(1) += ! any (w);
  end
end

## ----------------------------------------------------------------------------- bodies and the tree

function m = bodies (m, n)
  m.turns = [1, 0, 0, 0];                 # the ground's frame is the world's
  m.origins = zeros (1, 3);
  for b = 1:n
    shape = reshape (decimals (9, 1), 3, 3);
    ## integral of r r' dm, positive definite
    shape = round (100 * (shape * shape' + eye (3) / 10)) / 100;
    m.body = [m.body, struct("name", sprintf ("b%d", b), "mass", round (50 + 200 ...
          * rand) / 100, "com", decimals (3, 1), ...
                             "inertia", trace (shape) * eye (3) ...
                                 - shape, "parameter", chance (0.2))];
    m.turns(b + 1, :) = quaternion ();
    m.origins(b + 1, :) = decimals (3, 1);
  end
end

## every body hangs on one before it, on the last one with the chance 1 - branch
function m = tree (m, types, branch)
  for b = 1:numel (m.body)
    parent = b - 1;
    if (chance (branch))
      parent = randi ([0, b - 1]);
    end
    type = pick (types);
    if (strcmp (type, "free") && chance (0.5))
      type = pick (types);
    end
    if (strcmp (type, "fixed") && (b == 1 || chance (0.5)))
      type = pick (setdiff (types, "fixed"));
    end
    ends = {[parent, b], [b, parent]}{1 + chance (0.25)};     # drawn from ground on, or towards it
    m.joint = [m.joint, ...
               with_frames(joint_of_type (sprintf ("j%d", b), type, ends(1), ends(2)), ...
                           decimals (3, 1), quaternion ())];
  end
end

function joint = with_frames (joint, point, quaternion)
  [joint.point_a, joint.point_b] = deal (point);
  [joint.quaternion_a, joint.quaternion_b] = deal (quaternion);
  [joint.frame_a, joint.frame_b] = deal (ne_turn (quaternion));
end

## a joint with axes, pitch and orientation drawn by chance
function joint = joint_of_type (name, type, parent, child)
  units = {[1, 0, 0], [0, 1, 0], [0, 0, 1]};
  more = {-[1, 0, 0], -[0, 1, 0], -[0, 0, 1], [1, 2, 2], [2, -3, 6], [3, 0, -4], [1, 0, 1], ...
          randi([1, 2], 1, 3)};
  axis = pick ([units, units, more]);
  if (strcmp (type, "planar"))
    axis = pick (units);
  end
  second = [0, 0, 0];
  while (! any (second))
    second = cross (axis, pick ([units, more]));
  end
  orientation = zeros (0, 3);
  if (chance (0.4))
    orientation = pick ({[1, 2, 3], [3, 1, 3], [3, 2, 1], [2, 1, 2], [1, 3, 1], [2, 3, 1]});
  end
  if (strcmp (type, "rolling"))
    second = pick ([units, more]);
  end
  sequence = eye (3)(:, orientation);
  joint = ne_joint (name, type, parent, child, "axis", axis', "second", second', "pitch", (2 ...
          * chance (0.5) - 1) * round (5 + 25 * rand) / 100, ...
                    "orientation", sequence, "radius", round (30 + 70 * rand) / 100);
  joint.whole_axis = axis;
  joint.whole_second = second;
  joint.sequence = orientation;
  [joint.quaternion_a, joint.quaternion_b] = deal ([1, 0, 0, 0]);
  joint.named = true;
  [joint.q, joint.u] = deal ({});
  joint.friction = zeros (size (joint.damping));
  joint.motion = repmat ({false}, 1, numel (joint.damping));
end

## a ring that closes where all coordinates are zero, and moves
function m = closed_ring (m, most)
  for draw = 1:20
    new = bodies (m, randi ([3, max(3, most - 1)]));
    if (strcmp (m.kind, "spherical"))
      new = meeting (new);
    else
      new = ring (new);
    end
    closing = new.joint(end);
    new.joint(end) = [];
    new.start = rest (new);
    new = add_loop (new, closing);
    H = ne_jacobian (ne_rows (new, new.start));
    s = svd (H);
    ## it moves, and not at a dead centre
    if (sum (s > 1e-9) < columns (H) && s(2) > 0.2 && ! any (s > 1e-9 & s < 0.2))
      break;
    end
  end
  m = new;
end

## a ring whose revolutes, screws and cylinders stand along one direction of the world
function m = ring (m)
  wide = chance (0.5);                    # all screws along the direction; else motion in a plane
  along = quaternion ();
  kinds = {{"revolute", "prismatic", "planar"}, ...
           {"revolute", "helical", "cylindrical", "prismatic"}}{1 + wide};
  for b = 1:numel (m.body) + 1
    [parent, child] = deal (b - 1, b * (b <= numel (m.body)));
    type = pick (kinds);
    if (b == 1 || b > numel (m.body))
      type = pick (setdiff (kinds, "planar"));
    end
    joint = joint_of_type (sprintf ("j%d", b), type, parent, child);
    spin = pick ({[1, 0, 0, 0], [1, 0, 0, 1], [2, 0, 0, 1]});    # the joint's z along the direction
    joint.whole_axis = [0, 0, 1];
    if (strcmp (type, "prismatic"))
      joint.whole_axis = pick ({[1, 0, 0], [0, 1, 0], [3, 4, 0]});
    end
    joint.axis = joint.whole_axis' / norm (joint.whole_axis);
    m.joint = [m.joint, with_frames(joint, decimals (3, 1), product (along, spin))];
  end
end

## a ring of revolutes whose axes meet in one point
function m = meeting (m)
  centre = decimals (3, 1);
  for b = 1:numel (m.body) + 1
    joint = joint_of_type (sprintf ("j%d", b), "revolute", b - 1, b * (b <= numel (m.body)));
    m.joint = [m.joint, ...
               with_frames(joint, centre + joint.whole_axis' * round (10 + 30 * rand) / 100, ...
                           [1, 0, 0, 0])];
  end
end

function r = product (p, q)
  r = [p(1) * q(1) - p(2:4) * q(2:4)', p(1) * q(2:4) + q(1) * p(2:4) + cross(p(2:4), q(2:4))];
end

## ------------------------------------------------------------------------------------------- names

## default names for some joints, names of the scene's own for the others
function m = names (m)
  [m.q, m.u] = deal ({});
  for b = 1:numel (m.joint)
    if (strcmp (m.kind, "tree"))
      m.joint(b).named = chance (0.7);
    end
    [m.joint(b).q, m.joint(b).u] = joint_names (m.joint(b), m.joint(b).named);
    m.q = [m.q, m.joint(b).q];
    m.u = [m.u, m.joint(b).u];
  end
end

function [q, u] = joint_names (joint, named)
  [nq, nu] = ne_sizes (joint);
  stem = "q_";
  if (named)
    stem = "x_";
  end
  number = @(k) sprintf ("%d", k);
  ball = nq > nu;
  count = 1:nq;
  if (ball && strcmp (joint.type, "spherical"))
    count -= 1;
  end
  q = arrayfun (@(k) [stem joint.name number(k)], count, "UniformOutput", false);
  if (nq == 1)
    q = {[stem joint.name]};
  end
  own = nu - 3 * ball;
  u = cellfun (@(x) [x "_d"], q(1:own), "UniformOutput", false);
  if (ball)
    u = [u, cellfun(@(x) [joint.name "_w" x], {"x", "y", "z"}, "UniformOutput", false)];
  end
end

## --------------------------------------------------------------------------------------- positions

function q = rest (m)
  q = zeros (0, 1);
  for joint = m.joint
    [nq, nu] = ne_sizes (joint);
    own = zeros (nq, 1);
    if (nq > nu)
      own(nq - 3) = 1;
    end
    q = [q; own];
  end
end

## angles and displacements up to one unit
function q = somewhere (m)
  q = ne_advance (m, rest (m), 2 * rand (sum (nthargout (2, @ne_sizes, m)), 1) - 1);
end

## ------------------------------------------------------------------------------------------- loops

## up to `wanted` loops that close near m.start and leave the mechanism mobile
function m = loops (m, types, wanted)
  for draw = 1:20
    if (numel (m.loop) == wanted)
      break;
    end
    bodies = randperm (numel (m.body) + 1)(1:2) - 1;
    type = pick (types);
    if (strcmp (type, "rolling"))
      bodies = sort (bodies);             # ground is no disc
    end
    [joint, whole] = closed (m, ...
                             joint_of_type (sprintf ("c%d", numel (m.loop) + 1), type, ...
                               bodies(1), bodies(2)));
    if (mobile (add_loop (m, whole), m.start))
      new = add_loop (m, joint);
      [new.start, left] = ne_assemble (new, m.start, 0, 15);
      if (left < 1e-12 && mobile (new, new.start))
        m = new;
      end
    end
  end
end

## the joint's place in its child such that it stands at coordinates drawn by chance while the tree
## stands at m.start: with rounded numbers, and as it is
function [joint, whole] = closed (m, joint)
  if (strcmp (joint.type, "rolling"))
    [joint, whole] = touching (m, joint);
    return;
  end
  joint = with_frames (joint, decimals (3, 1), quaternion ());
  k = ne_rows (m, m.start);
  [~, nu] = ne_sizes (joint);
  own = struct ("joint", joint);
  [s, R] = ne_freedom (joint, somewhere (own), zeros (nu, 1));
  [RA, xA] = pose (k, joint.parent);
  [RB, xB] = pose (k, joint.child);
  x = xA + RA * (joint.point_a + joint.frame_a * s);
  whole = joint;
  whole.point_b = RB' * (x - xB);
  whole.frame_b = RB' * RA * joint.frame_a * R;
  joint.point_b = round (100 * whole.point_b) / 100;
  joint.quaternion_b = round (8 ...
                                * ne_measure (ne_joint ("", "spherical", 0, 1), zeros (3, 1), ...
                                  whole.frame_b)');
  joint.frame_b = ne_turn (joint.quaternion_b);
end

## a disc of the child that touches a plane of the parent; no joint axes of their own
function [joint, whole] = touching (m, joint)
  k = ne_rows (m, m.start);
  joint.point_b = decimals (3, 1);
  [RA, xA] = pose (k, joint.parent);
  [RB, xB] = pose (k, joint.child);
  joint.axis = ne_turn (m.turns(joint.child + 1, :)) * joint.axis;
  joint.second = ne_turn (m.turns(joint.parent + 1, :)) * joint.second;
  off = joint.radius * sqrt (max (0.01, 1 - (joint.second' * RA' * RB * joint.axis) ^ 2));
  whole = joint;
  whole.point_a = RA' * (xB + RB * joint.point_b - xA) - off * joint.second;
  joint.point_a = round (100 * whole.point_a) / 100;
end

function [R, x] = pose (k, b)
  [R, x] = deal (eye (3), zeros (3, 1));
  if (b)
    [R, x] = deal (k.R(:, :, b), k.origin(:, b));
  end
end

function m = add_loop (m, joint)
  joint.tracked = strcmp (joint.type, "helical") && parallel (m, joint);
  [joint.q, joint.u] = joint_names (joint, false);
  m.loop = [m.loop, joint];
  m.loop_q = [m.loop_q, joint.q];
  m.loop_u = [m.loop_u, joint.u];
end

## one of the links of a loop is cut in halves instead of a joint (where GSMBP may choose)
function m = lilov (m)
  if (m.auto && numel (m.loop) == 1 && chance (0.4))
    m.cut_link = pick (num2cell (setxor (way (m, m.loop.parent), way (m, m.loop.child))));
  end
end

## true if all joints from ground to the ends of the loop joint turn about axes parallel to its own
function yes = parallel (m, joint)
  yes = true;
  k = ne_rows (m, rest (m));
  for side = {{joint.parent, joint.frame_a}, {joint.child, joint.frame_b}}
    [R, ~] = pose (k, side{1}{1});
    axis = R * side{1}{2} * joint.axis;
    for b = way (m, side{1}{1})
      own = m.joint(b);
      [R, ~] = pose (k, own.parent);
      yes &= any (strcmp (own.type, {"prismatic", "fixed"})) ...
          || (any (strcmp (own.type, {"revolute", "helical", "cylindrical", "planar"})) ...
                                                                && norm (cross (axis, ...
                                                                      R * own.frame_a ...
                                                                        * own.axis)) < 1e-9);
    end
  end
end

## the bodies from ground to body b
function list = way (m, b)
  list = [];
  while (b)
    list(end + 1) = b;
    b = m.joint(b).parent + m.joint(b).child - b;
  end
end

## true if the rows are independent at the position q, and something can move still; a disc that
## lies flat has no rows
function yes = mobile (m, q)
  H = ne_jacobian (ne_rows (m, q));
  if (! all (isfinite (H(:))))
    yes = false;
    return;
  end
  s = svd (H);
  yes = rows (H) < columns (H) && s(end) > 1e-2 * max (s(1), 1);
end

## -------------------------------------------------------------------- forces, springs, constraints

function m = efforts (m)
  for b = 1:numel (m.joint)
    joint = m.joint(b);
    [nq, nu] = ne_sizes (joint);
    own = nu - 3 * (nq > nu);
    if (own && ! m.auto && chance (0.5))
      m.joint(b).damping(1:own) = round (100 * rand (own, 1)) / 100;
      m.joint(b).friction = m.joint(b).damping;
    end
    for k = 1:own * ! m.auto
      if (chance (0.1))
        more = round (100 * rand) / 100;
        m.joint(b).damping(k) += more;
        m.elements{end + 1} = ...
            sprintf ("damper(d%d, joint = %s%s, damping = %s)", numel (m.elements), joint.name, ...
                     of_coordinate (joint, ...
            k), ...
                                       hundredths (more));
      end
      if (chance (0.15))
        m.joint(b).stiffness(k) = round (500 * rand) / 100;
        m.joint(b).rest(k) = decimals (1, 1);
        m.elements{end + 1} = ...
            sprintf ("spring(s%d, joint = %s%s, stiffness = %s, rest = %s)", numel (m.elements), ...
                     joint.name, of_coordinate (joint, ...
            k), ...
                                       hundredths (m.joint(b).stiffness(k)), ...
                                           hundredths (m.joint(b).rest(k)));
      end
    end
  end
  if (chance (0.2))
    body = randi (numel (m.body));
    f = struct ("body", body, "point", decimals (3, 1), "force", decimals (3, 5), "torque", ...
                zeros (3, 1), "frame", pick ({"ground", "link"}));
    if (chance (0.4))
      [f.force, f.torque] = deal (zeros (3, 1), f.force);
    end
    f.vector = f.force + f.torque;
    if (strcmp (f.frame, "link"))         # the numbers are in the link's own axes
      R = ne_turn (m.turns(body + 1, :));
      [f.force, f.torque] = deal (R * f.force, R * f.torque);
    end
    m.given = f;
  end
  if (chance (0.15))
    b = randperm (numel (m.body) + 1)(1:2) - 1;
    m.spring = struct ("a", b(1), "point_a", decimals (3, 1), "b", b(2), "point_b", decimals (3, ...
          1) + [3; 0; 0], "stiffness", round (500 * rand) / 100, ...
                       "rest", round (100 * rand) / 100, "damping", round (100 * rand) / 100 ...
                           * chance (0.5));
  end
end

## the coordinate's name where a joint has several
function text = of_coordinate (joint, k)
  text = "";
  if (numel (joint.q) > 1)
    text = [", coordinate = " joint.q{k}];
  end
end

## driven coordinates, holonomic and non-holonomic constraints between ordinary coordinates
function m = laws (m)
  [ordinary, of_speed] = plain_coordinates (m);
  for i = 1:numel (ordinary)
    if (! chance (0.06))
      continue;
    end
    [kq, ku] = deal (ordinary(i), of_speed(i));
    w = round (100 + 200 * rand) / 100;
    a = decimals (1, 0.5);
    c = round (100 * (m.start(kq) - a * sin (w * m.start_time))) / 100;
    law = sprintf ("%s + %s*sin(%s*t)", hundredths (c), hundredths (a), hundredths (w));
    before = numel (m.user);
    m = with_user (m, @(t, q, u) driven (c, a, w, kq, ku, t, q, u), ...
                   sprintf ("motion(law%d, coordinate = %s, law = %s)", i, m.q{kq}, law));
    if (numel (m.user) > before && chance (0.5))   # as an option of the joint
      m.elements(end) = [];
      m = with_motion (m, kq, law);
    end
  end
  if (numel (ordinary) > 2 && chance (0.12))
    i = randperm (numel (ordinary))(1:2);
    [kq, ku] = deal (ordinary(i), of_speed(i));
    a = decimals (3, 1) + 0.005;
    a = round (100 * a + ! round (100 * a)) / 100;
    q = m.start(kq);
    c = round (100 * (a(1) * q(1) + a(2) * q(2) + a(3) * q(1) * q(2))) / 100;
    x = m.q(kq);
    m = with_user (m, @(t, q, u) holonomic (a, c, kq, ku, q, u), ...
                   sprintf ("constraint(hol, %s*%s + %s*%s + %s*%s*%s - %s)", hundredths (a(1)), ...
                            x{1}, hundredths (a(2)), x{2}, hundredths (a(3)), x{:}, ...
                            hundredths (c)));
  end
  if (numel (ordinary) > 0 && numel (m.u) > 2 && chance (0.12))
    i = randi (numel (ordinary));
    ## angular velocities too
    [kq, ku] = deal (ordinary(i), ...
                     [of_speed(i), pick(num2cell (setdiff (1:numel (m.u), of_speed(i))))]);
    a = decimals (3, 1);
    a(1) += ! a(1);
    m = with_user (m, @(t, q, u) of_speeds (a, kq, ku, q, u), ...
                   sprintf ("constraint(non, %s*%s + (%s + %s*%s)*%s)", hundredths (a(1)), ...
                            m.u{ku(1)}, hundredths (a(2)), hundredths (a(3)), m.q{kq}, ...
                            m.u{ku(2)}));
  end
end

## two speeds of the scene's own in place of two rates
function m = own_speeds (m)
  [kq, ku] = plain_coordinates (m);
  if (numel (kq) < 2 || ! chance (0.15))
    return;
  end
  i = randperm (numel (kq))(1:2);
  [kq, ku, a] = deal (kq(i), ku(i), decimals (2, 0.5));
  m.speeds = @(q, u) mixed (a, kq, ku, q, u);
  text = ...
      sprintf ("speeds = [mix1 = %s + %s*%s, mix2 = %s + %s*sin(%s)*%s]", m.u{ku(1)}, ...
               hundredths (a(1)), m.u{ku(2)}, m.u{ku(2)}, hundredths (a(2)), ...
                  ratio (m, kq(1)), m.u{ku(1)});
  [m.elements{end + 1}, m.u_own(ku)] = deal (text, {"mix1", "mix2"});
end

function [A, Adu] = mixed (a, kq, ku, q, u)
  A = eye (numel (u));
  A(ku(1), ku(2)) = a(1);
  A(ku(2), ku(1)) = a(2) * sin (q(kq(1)));
  Adu = zeros (numel (u), 1);
  Adu(ku(2)) = a(2) * cos (q(kq(1))) * u(ku(1)) ^ 2;
end

## a link without mass, if the others and the loops hold it
function m = massless (m)
  if (! chance (0.15) || ! isempty (m.cut_link))
    return;
  end
  new = m;
  b = randi (numel (m.body));
  [new.body(b).mass, new.body(b).inertia] = deal (0, zeros (3));
  k = ne_rows (new, m.start, zeros (numel (m.u), 1), m.start_time);
  [H, B] = deal (ne_jacobian (k), k.J \ k.E);
  K = [B' * k.mass * B, -H'; H, zeros(rows (H))];
  if (rcond (K) > 1e-6)
    m = new;
  end
end

## numbers of the coordinates that are no Euler parameters, and of their speeds
function [q, u] = plain_coordinates (m)
  q = u = [];
  [nq, nu] = ne_sizes (m);
  for b = 1:numel (nq)
    own = 1:(nu(b) - 3 * (nq(b) > nu(b)));
    q = [q, sum(nq(1:b-1)) + own];
    u = [u, sum(nu(1:b-1)) + own];
  end
end

## what may stand in a sine: an angle, or a length over 1 m
function text = ratio (m, kq)
  [nq, ~] = ne_sizes (m);
  b = find (cumsum (nq) >= kq, 1);
  text = m.q{kq};
  if (strcmp (ne_moves (m.joint(b)){kq - sum (nq(1:b-1))}{1}, "slide"))
    text = [text "/m"];
  end
end

function m = with_motion (m, kq, law)
  [nq, ~] = ne_sizes (m);
  b = find (cumsum (nq) >= kq, 1);
  m.joint(b).motion{kq - sum (nq(1:b-1))} = law;
end

## the mechanism with one more condition, if it still closes and moves
function m = with_user (m, f, text)
  new = m;
  new.user{end + 1} = f;
  [q, left] = ne_assemble (new, m.start, m.start_time, 15);
  H = ne_jacobian (ne_rows (new, q, "still", m.start_time));
  s = svd (H);
  if (left < 1e-12 && rank (H) == rank (ne_jacobian (ne_rows (m, q, "still", m.start_time))) + 1 ...
      && s(end) > 1e-3 * s(1) ...
      && rows (H) < columns (H))
    m = new;
    m.start = q;
    m.elements{end + 1} = text;
  end
end

function [gap, row, rate, gamma] = driven (c, a, w, kq, ku, t, q, u)
  gap = q(kq) - c - a * sin (w * t);
  row = 1:numel (u) == ku;
  rate = a * w * cos (w * t);
  gamma = -a * w ^ 2 * sin (w * t);
end

function [gap, row, rate, gamma] = holonomic (a, c, kq, ku, q, u)
  gap = a(1) * q(kq(1)) + a(2) * q(kq(2)) + a(3) * q(kq(1)) * q(kq(2)) - c;
  row = zeros (1, numel (u));
  row(ku) = [a(1) + a(3) * q(kq(2)), a(2) + a(3) * q(kq(1))];
  rate = 0;
  gamma = -2 * a(3) * u(ku(1)) * u(ku(2));
end

function [gap, row, rate, gamma] = of_speeds (a, kq, ku, q, u)
  gap = rate = 0;
  row = zeros (1, numel (u));
  row(ku) = [a(1), a(2) + a(3) * q(kq(1))];
  gamma = -a(3) * u(ku(1)) * u(ku(2));
end
