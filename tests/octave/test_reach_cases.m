## Inverse kinematics where a scene is not a bare arm: a chain on a carriage, with a fixed joint,
## turned joints, starts and a branch beside it; how far poses are that cannot be reached, against
## searches of another kind; what is free at singular poses; Newton's method within limits.

function test_reach_cases ()
  mounted (gsmbp_fixture ("reach_mounted"));
  centre_distance (gsmbp_fixture ("reach_puma"), [0; 0; 0.1]);
  centre_distance (gsmbp_fixture ("reach_pieper"), [-0.2; 0.05; 0.1]);
  pose_distance (gsmbp_fixture ("reach_parallel"));
  free_directions (gsmbp_fixture ("reach_puma"), gsmbp_fixture ("reach_stanford"));
  newton_within_limits (gsmbp_fixture ("reach_puma"));
  legs_out_of_reach (gsmbp_fixture ("reach_arms"));
  stretched (gsmbp_fixture ("reach_crank"));
end

## every pose of the tool is found again, the carriage given, whatever the lamp does
function mounted (m)
  [~, at] = ismember ({"q1", "q2", "q3", "q4", "q5", "q6"}, m.coordinates);
  [~, s] = ismember ("s", m.coordinates);
  rand ("seed", 11);
  [lost, miss] = deal (0);
  for k = 1:100
    q = 5 * (rand (m.sizes.nq, 1) - 0.5);
    [P, R] = m.pnt (0, q);
    [qs, ns] = m.ikn (P, R, q(s));
    d = qs(:,1:ns) - q(at)(:);
    lost += ns == 0 || min (max (abs (d - 2 * pi * round (d / (2 * pi))), [], 1)) > 1e-7;
    for j = 1:ns
      [p, r] = m.pnt (0, setfield_at (q, at, qs(:,j)));
      miss = max ([miss; abs(p - P); abs(r - R)(:)]);
    end
  end
  gsmbp_check ("arm on a carriage: of 100 poses lost", lost, 0);
  gsmbp_check ("arm on a carriage: what the solutions miss", miss, 1e-12);
  start = m.initial(1:m.sizes.nq);
  [P, R] = m.pnt (0, start);
  r = gsmbp_reach (m, "tool", P, R, "given", start(s));
  gsmbp_check ("arm on a carriage: at the start, the start is found", r - start, 1e-10);
end

function q = setfield_at (q, at, x)
  q(at) = x;
end

## DST(1) against the least distance of the wrist's centre, which stands at -e in the axes of the
## tool, over three joints: descents from many places
function centre_distance (m, e)
  worst = 0;
  rand ("seed", 3);
  for k = 1:4
    [~, R] = m.pnt (0, 6 * (rand (6, 1) - 0.5));
    direction = [1, 0.02, -2, 0.3; 0.5, 0.03, 0.4, -1.5; 1.2, 1.3, 2, 1.5](:,k);
    c = direction * (1 + (k != 2));
    [~, ~, ~, dst, info] = m.ikn (c + R * e, R);
    least = Inf;
    for start = 1:8
      q = least_squares (@(q) c - centre (m, q, e), 6 * (rand (3, 1) - 0.5));
      least = min (least, norm (c - centre (m, q, e)));
    end
    gsmbp_check (sprintf ("%s: pose %d is out of reach", m.name, k), (info == 1) == (least > 1e-9));
    if (info == 1)
      worst = max (worst, abs (dst(1) - least) / least);
    end
  end
  gsmbp_check ([m.name ": distance of the wrist's centre"], worst, 1e-8);
end

function c = centre (m, q, e)
  [p, r] = m.pnt (0, [q; 0; 0; 0]);
  c = p - r * e;
end

## Levenberg and Marquardt with differences of the function f
function q = least_squares (f, q)
  mu = 1e-3;
  r = f (q);
  for it = 1:1000
    J = zeros (numel (r), numel (q));
    for k = 1:numel (q)
      h = zeros (numel (q), 1);
      h(k) = 1e-6;
      J(:,k) = (f (q + h) - f (q - h)) / 2e-6;
    end
    step = -(J' * J + mu * eye (numel (q))) \ (J' * r);
    new = f (q + step);
    if (sumsq (new) < sumsq (r))
      q += step;
      r = new;
      mu = max (mu / 10, 1e-12);
    else
      mu *= 10;
    end
    if (mu > 1e8 || norm (step) < 1e-12)
      return;
    end
  end
end

## where all joints together decide: least squares of place [m] and rotation vector [rad]
function pose_distance (m)
  rand ("seed", 4);
  for k = 1:2
    [~, R] = m.pnt (0, 6 * (rand (6, 1) - 0.5));
    P = [1.1, 0.3; -0.6, 1.4; 0.8, -1](:,k);
    [~, ~, ~, dst, info] = m.ikn (P, R);
    least = Inf;
    for start = 1:15
      q = least_squares (@(q) pose_error (m, q, P, R), 6 * (rand (6, 1) - 0.5));
      least = min (least, norm (pose_error (m, q, P, R)));
    end
    gsmbp_check (sprintf ("%s: pose %d: least error of place and axes", m.name, k), ...
                 (norm (dst) - least) / least, 1e-7);
    gsmbp_check (sprintf ("%s: pose %d is out of reach", m.name, k), info == 1);
  end
end

function e = pose_error (m, q, P, R)
  [p, r] = m.pnt (0, q);
  W = R * r';
  v = [W(3,2) - W(2,3); W(1,3) - W(3,1); W(2,1) - W(1,2)] / 2;
  e = [P - p; v / max(norm (v), 1e-300) * atan2(norm (v), (trace (W) - 1) / 2)];
end

## what the inverse kinematics calls free does not move the tool: null space of a Jacobian by
## differences of places and axes
function free_directions (puma, stanford)
  wrist = [0.4; -0.7; 0.9; 0.3; 0; -0.5];
  elbow = [0.4; -0.7; -atan2(0.4318, 0.0203); 0.3; 0.8; -0.5];
  for q = [wrist, elbow]
    free_direction (puma, q);
  end
  free_direction (stanford, [0.4; -0.7; 0.3; 0.6; pi/2; 0.2]);
  free_direction (stanford, [0.4; -0.7; 0.3; 0.6; 0; 0.2]);
end

function free_direction (m, q)
  [P, R] = m.pnt (0, q);
  [~, info] = gsmbp_reach (m, "tool", P, R, "start", q);
  J = zeros (12, 6);
  for k = 1:6
    h = zeros (6, 1);
    h(k) = 1e-5;
    [p1, r1] = m.pnt (0, q + h);
    [p0, r0] = m.pnt (0, q - h);
    J(:,k) = [p1 - p0; (r1 - r0)(:)] / 2e-5;
  end
  [~, s, V] = svd (J);
  here = sprintf ("%s, q3 = %g, q5 = %g", m.name, q(3), q(5));
  if (s(6,6) < 1e-8)
    gsmbp_check ([here ": singular: said"], strcmp (info.status, "singular"));
    gsmbp_check ([here ": free direction"], abs (V(:,6)' * info.free) - 1, 1e-9);
  else
    gsmbp_check ([here ": regular: said"], strcmp (info.status, "ok") && all (info.free == 0));
  end
end

## of eight solutions the limits leave one, and none
function newton_within_limits (m)
  q = [0.3; -0.5; 0.7; 0.4; 0.8; -0.2];
  [P, R] = m.pnt (0, q);
  [qs, ns] = m.ikn (P, R);
  missed = 0;
  for k = 1:ns
    [r, info] = gsmbp_reach (m, "tool", P, R, "method", "newton", "limits", ...
                             qs(:,k) + [-0.3, 0.2], "start", qs(:,k) + 0.15);
    missed += ! strcmp (info.status, "ok") || max (abs (r - qs(:,k))) > 1e-9;
  end
  gsmbp_check ("Newton's method within limits: of 8 branches missed", missed, 0);
  lim = q + [0.1, 0.4];
  [r, info] = gsmbp_reach (m, "tool", P, R, "method", "newton", "limits", lim, "start", q + 0.2);
  gsmbp_check ("Newton's method: beyond the limits: said", ...
               strcmp (info.status, "unreachable") && all (isnan (r)));
  gsmbp_check ("Newton's method: beyond the limits: by how much", any (info.distance > 1e-3));
end

## two arms of 0.5 and 0.4 hold a beam at its ends: what the beam's end is beyond their reach
function legs_out_of_reach (m)
  [qs, ns, ~, dst, info] = m.ikn ([0; 0.6; 0], eye (3));
  gsmbp_check ("two arms: two solutions each", isequal (ns(:), [1; 2; 2]));
  gsmbp_check ("two arms: within reach: said", info == 0 && all (dst == 0));
  P = [0.3; 1; 0];
  [~, ns, ~, dst, info] = m.ikn (P, eye (3));
  far = [norm(P - [0.2; 0; 0] + [0.6; 0; 0]), norm(P + [0.2; 0; 0] - [0.6; 0; 0])] - 0.9;
  gsmbp_check ("two arms: out of reach: said", info == 1);
  gsmbp_check ("two arms: out of reach: of each", (far < 0)(:) == (ns(2:3)(:) == 2));
  gsmbp_check ("two arms: out of reach: how far", dst(1) - max (far), 1e-12);
  P = [0.45; 0.05; 0];
  [~, ns, ~, dst, info] = m.ikn (P, eye (3));
  near = 0.1 - norm (P + [0.2; 0; 0] - [0.6; 0; 0]);
  gsmbp_check ("two arms: too near: how far", dst(1) - near, 1e-12);
end

## from the stretched position, where no small step comes closer, and beyond reach, with the loop
## closed: 0.2 and 0.45 long, the pin 0.03 beside and 0.05 behind the end of its way
function stretched (m)
  [q, info] = gsmbp_reach (m, "pin", [0.5; 0; 0], [], "start", [0; 0; 0.5]);
  gsmbp_check ("stretched crank: said", strcmp (info.status, "ok"));
  gsmbp_check ("stretched crank: law of cosines", abs (q(1)) - acos (0.0875 / 0.2), 1e-9);
  [~, info] = gsmbp_reach (m, "pin", [0.7; 0.03; 0]);
  gsmbp_check ("crank out of reach: said", strcmp (info.status, "unreachable"));
  gsmbp_check ("crank out of reach: how far", info.distance(1) / hypot (0.05, 0.03) - 1, 1e-5);
end
