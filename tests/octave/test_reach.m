## Inverse kinematics: complete sets of solutions with 30 digits (tests/data/reach_...), round trips
## of poses made by chance for every closed form, poses close to singular ones, gsmbp_reach along
## paths and within limits. Places and axes of the solutions are those of PNT, which test_points
## holds against other references.

function test_reach ()
  for name = {"reach_puma", "reach_scara"}
    complete_sets (name{1});
  end
  for name = {"reach_parallel", "reach_parallel_apart", "reach_parallel_first", ...
              "reach_stanford", "reach_pieper", "reach_backwards", "reach_cylinder", ...
                "reach_general"}
    round_trips (gsmbp_fixture (name{1}));
  end
  seven_joints (gsmbp_fixture ("reach_seven"));
  legs (gsmbp_fixture ("reach_legs"));
  close_to_singular (gsmbp_fixture ("reach_puma"));
  folded (gsmbp_fixture ("reach_parallel"));
  double_solutions (gsmbp_fixture ("reach_general"));
  unreachable (gsmbp_fixture ("reach_scara"), gsmbp_fixture ("reach_puma"));
  paths (gsmbp_fixture ("reach_puma"));
  place_alone (gsmbp_fixture ("reach_puma"), gsmbp_fixture ("reach_general"));
  complaints (gsmbp_fixture ("reach_puma"), gsmbp_fixture ("reach_legs"));
end

## ------------------------------------------------------------------------------- complete sets

function complete_sets (name)
  m = gsmbp_fixture (name);
  [~, ref] = gsmbp_case (name);
  folder = fullfile (fileparts (mfilename ("fullpath")), "..", "data", name);
  spec = jsondecode (fileread (fullfile (folder, "spec.json")));
  turns = strcmp ({spec.joints.type}', "revolute");
  [status, missing, extra, number, residual, regular] = deal (0);
  for k = 1:numel (spec.poses)
    pose = element (spec.poses, k);
    [P, R] = deal (ne_numbers (pose.p), ne_numbers (pose.R));
    [qs, ns, ~, ~, info] = m.ikn (P, R);
    wanted = element (ref.poses, k);
    status += ! agrees (wanted.status, info);
    used = false (1, ns);
    for s = 1:ns
      [p, r] = m.pnt (0, qs(:,s));
      residual = max ([residual; abs(p - P); abs(r - R)(:)]);
    end
    for s = 1:wanted.n
      [hit, regular] = matches (element (wanted.solutions, s), qs(:,1:ns), turns, regular);
      number++;
      missing += ! any (hit);
      used |= hit;
    end
    extra += sum (! used);
  end
  gsmbp_check (sprintf ("%s: %d poses: status", name, numel (spec.poses)), status, 0);
  gsmbp_check (sprintf ("%s: of %d solutions missing", name, number), missing, 0);
  gsmbp_check ([name ": solutions that are none"], extra, 0);
  gsmbp_check ([name ": what the solutions miss of the pose [m, 1]"], residual, 1e-12);
  gsmbp_check ([name ": error of the coordinates of regular solutions"], regular, 1e-9);
end

function s = element (list, k)
  if (iscell (list))
    s = list{k};
  else
    s = list(k);
  end
end

function yes = agrees (word, info)
  yes = strcmp (word, "unreachable") == (info == 1) && ! (strcmp (word, "singular") && info != 2);
end

## which columns of qs are the solution s of the reference: 1e-9 for simple ones, more by its least
## singular value, 1e-6 for double ones and members of a family
function [hit, regular] = matches (s, qs, turns, regular)
  q = ne_numbers (s.q)(:);
  far = @(d) max (abs (d - turns .* (2 * pi * round (d / (2 * pi)))), [], 1);
  tol = 1e-6;
  d = qs - q;
  if (isfield (s, "selfmotion") && ! isempty (s.selfmotion))
    z = s.selfmotion(:);
    [~, j] = max (abs (z));
    d -= z * (d(j,:) / z(j));
  elseif (s.mult == 1)
    tol = 1e-9 + 1e-14 / max (str2double (s.sigma_min), 1e-11);
  end
  hit = far (d) <= tol;
  if (any (hit) && tol < 1.1e-9)
    regular = max (regular, min (far (d)));
  end
end

## --------------------------------------------------------------------------------- round trips

function round_trips (m, count = 300)
  rand ("seed", 7);
  turns = strcmp ({m.json.coordinates.unit}', "rad");
  [lost, off] = deal (0);
  for k = 1:count
    q = (rand (m.sizes.nq, 1) - 0.5) .* (1 + 5.2 * turns) + ! turns;
    [found, miss] = found_again (m, q, turns);
    lost += ! found;
    off = max (off, miss);
  end
  gsmbp_check (sprintf ("%s: of %d poses lost", m.name, count), lost, 0);
  gsmbp_check ([m.name ": what the solutions miss of the pose"], off, 1e-9);
end

## whether q is among the solutions for its own pose: to 1e-6, or nearby with a pose that is the
## same to 1e-14, so that nothing tells the two apart; what the solutions miss of the pose
function [found, miss] = found_again (m, q, turns, given = {})
  [P, R] = m.pnt (0, q);
  [qs, ns] = m.ikn (P, R, given{:});
  rest = numel (given) > 0;
  d = qs(:,1:ns) - q(1:end-rest);
  d -= turns(1:end-rest) .* (2 * pi * round (d / (2 * pi)));
  d = max (abs (d), [], 1);
  missed = zeros (1, ns);
  for s = 1:ns
    [p, r] = m.pnt (0, [qs(:,s); given{:}]);
    missed(s) = max ([abs(p - P); abs(r - R)(:)]);
  end
  found = any (d < 1e-6 | d < 1e-4 & missed < 1e-14);
  miss = max ([0, missed]);
end

function seven_joints (m)
  rand ("seed", 5);
  [lost, off] = deal (0);
  for k = 1:200
    q = 5.6 * (rand (7, 1) - 0.5);
    [found, miss] = found_again (m, q, true (7, 1), {q(7)});
    lost += ! found;
    off = max (off, miss);
  end
  gsmbp_check ("seven joints, the last one given: of 200 poses lost", lost, 0);
  gsmbp_check ("seven joints: what the solutions miss of the pose", off, 1e-10);
  q = [0.3; -0.4; 0.5; -1.7; 0.6; 2; 0.7];
  [P, R] = m.pnt (0, q);
  [r, info] = gsmbp_reach (m, "tool", P, R, "given", 0.7, "start", q + 0.1);
  gsmbp_check ("gsmbp_reach with a coordinate given", r - q, 1e-10);
end

## every leg by itself, and all of it by Newton's method
function legs (m)
  P = [0.02; -0.03; 1.05];
  e = [1; 0.05; -0.04; 0.1];
  q = gsmbp_reach (m, "plate", P, e);
  [p, R] = m.pnt (0, q);
  gsmbp_check ("three legs: place of the plate", p - P, 1e-13);
  gsmbp_check ("three legs: loops closed", m.con (0, q, zeros (m.sizes.nu, 1)), 1e-12);
  [qs, ns, br, dst, info] = m.ikn (P, R);
  gsmbp_check ("three legs: four solutions each", ns == 4);
  for k = 0:2
    [~, places] = ismember (cellstr (m.json.reach.chains(k+1).coordinates), m.coordinates);
    d = qs(3*k+1:3*k+3,:) - q(places);
    d(1:2,:) -= 2 * pi * round (d(1:2,:) / (2 * pi));
    gsmbp_check (sprintf ("three legs: leg %d as Newton's method has it", k + 1), ...
                 min (max (abs (d), [], 1)), 1e-10);
  end
end

## ----------------------------------------------------------------------------- singular, too far

## 1e-3 to 1e-9 beside the wrist and the stretched elbow: no branch is lost
function close_to_singular (m)
  elbow = -atan2 (0.4318, 0.0203);   # the wrist in line with the upper arm
  for d = 10 .^ (-3:-1:-9)
    for which = 1:2
      q = [0.4; -0.7; 0.9; 0.3; 0.8; -0.5];
      if (which == 1)
        q(5) = d;
      else
        q(3) = elbow + d;
      end
      [found, miss] = found_again (m, q, true (6, 1));
      [P, R] = m.pnt (0, q);
      [~, ns] = m.ikn (P, R);
      words = {"wrist", "elbow"}{which};
      gsmbp_check (sprintf ("%g rad beside the singular %s: 8 solutions, its own among them", ...
                            d, words), found && (ns == 8 || (which == 2 && d < 3e-8)));
      gsmbp_check (sprintf ("%g rad beside the singular %s: what they miss", d, words), miss, ...
        1e-12);
    end
  end
end

## the elbow folded and stretched: INFO = 2, whatever rounding makes of the root
function folded (m)
  rand ("twister", 3);
  for q3 = [0, pi]
    wrong = 0;
    for k = 1:25
      q = 5.6 * (rand (6, 1) - 0.5);
      q(3) = q3;
      wrong += ! said_singular (m, q);
    end
    gsmbp_check (sprintf ("elbow at %g rad: of 25 poses not said to be singular", q3), wrong, 0);
  end
end

## general arm: double solutions come once, with INFO = 2; others with INFO = 0
function double_solutions (m)
  rand ("twister", 3);
  determinant = @(q) det (m.jpt (0, q, zeros (6, 1))(1:6,1:6));
  at = linspace (-pi, pi, 40);
  [count, wrong, twice, lost, plain] = deal (0);
  while (count < 20)
    q = 5.6 * (rand (6, 1) - 0.5);
    [P, R] = m.pnt (0, q);
    [~, ~, ~, ~, info] = m.ikn (P, R);
    plain += info != 0;
    f = @(x) determinant ([q(1:2); x; q(4:6)]);
    y = arrayfun (f, at);
    k = find (y(1:end-1) .* y(2:end) < 0, 1);
    if (isempty (k))
      continue;
    end
    count++;
    q(3) = fzero (f, at(k:k+1));
    [said, n] = said_singular (m, q);
    wrong += ! said;
    twice += n > 1;
    lost += n == 0;
  end
  gsmbp_check ("general arm: of 20 singular poses not said to be so", wrong, 0);
  gsmbp_check ("general arm: of their double solutions lost, twice", [lost, twice], 0);
  gsmbp_check ("general arm: of other poses said to be singular", plain, 0);
end

## does IKN say that the pose of q is singular, and gsmbp_reach? N: solutions that are q to 1e-5
function [yes, n] = said_singular (m, q)
  [P, R] = m.pnt (0, q);
  [qs, ns, ~, ~, info] = m.ikn (P, R);
  [~, told] = gsmbp_reach (m, "tool", P, R, "start", q);
  yes = info == 2 && strcmp (told.status, "singular");
  off = qs(:,1:ns) - q;
  n = sum (max (abs (off - 2 * pi * round (off / (2 * pi))), [], 1) < 1e-5);
end

function unreachable (scara, puma)
  ## SCARA of arms 0.325 and 0.275: 0.9 from the axis is 0.3 too far; a tilt of 0.1
  [~, info] = gsmbp_reach (scara, "tool", [0.9; 0; 0.2], diag ([1, -1, -1]));
  gsmbp_check ("out of reach: said", strcmp (info.status, "unreachable"));
  gsmbp_check ("out of reach: how far", info.distance(1) - 0.3, 1e-9);
  tilt = [1, 0, 0; 0, cos(0.1), -sin(0.1); 0, sin(0.1), cos(0.1)];
  [~, info] = gsmbp_reach (scara, "tool", [0.4; 0; 0.2], tilt * diag ([1, -1, -1]));
  gsmbp_check ("tilted axis: said", strcmp (info.status, "unreachable"));
  gsmbp_check ("tilted axis: by how much", info.distance(2) - 2 * sin (0.05), 1e-3);
  ## the wrist of the PUMA inside the cylinder that its offset leaves free
  d3 = 0.15005;
  P = [0.05; 0; 0.9] + [0; 0; 0.1];
  [~, info] = gsmbp_reach (puma, "tool", P, eye (3));
  gsmbp_check ("inside the cylinder about axis 1: how far", info.distance(1) - (d3 - 0.05), 1e-9);
end

## --------------------------------------------------------------------------------------- paths

function paths (m)
  q = [0.3; -0.5; 0.7; 0.4; 0.8; -0.2] + linspace (0, 1, 30) .* [1; 0.5; 0.2; 4; -0.3; 6];
  for k = 30:-1:1
    [P(:,k), R(:,:,k)] = m.pnt (0, q(:,k));
  end
  r = gsmbp_reach (m, "tool", P, R, "start", q(:,1));
  gsmbp_check ("path: continuous over more than a turn", r - q, 1e-11);
  n = gsmbp_reach (m, "tool", P, R, "start", q(:,1) + 0.1, "method", "newton");
  gsmbp_check ("path by Newton's method", n - q, 1e-9);
  lim = [-pi, pi] .* ones (6, 1);
  [r, info] = gsmbp_reach (m, "tool", P, R, "start", q(:,1), "limits", lim);
  inside = all (isfinite (r), 1);
  gsmbp_check ("path within limits", all (abs (r(:,inside))(:) <= pi + 1e-12) && all (inside));
  lim(2,:) = [0.2, 0.21];
  [r, info] = gsmbp_reach (m, "tool", P(:,1), R(:,:,1), "limits", lim);
  gsmbp_check ("no solution within the limits: said", ...
               strcmp (info.status, "limits") && all (isnan (r)));
  [r, info] = gsmbp_reach (m, "tool", P(:,1), R(:,:,1), "branch", 3);
  gsmbp_check ("a branch by its number", info.branch == 3 && norm (m.pnt (0, r) - P(:,1)) < 1e-13);
  asked_for (m, q(:,1), P(:,1), R(:,:,1));
  [~, info] = gsmbp_reach (m, "tool", P(:,1), R(:,:,1));
  gsmbp_check ("all solutions of a pose", size (info.solutions{1}) == [6, 8]);
  q5 = [0.3; -0.5; 0.7; 0.4; 0; -0.2];
  [P5, R5] = m.pnt (0, q5);
  [r, info] = gsmbp_reach (m, "tool", P5, R5, "start", q5);
  gsmbp_check ("singular wrist: said", strcmp (info.status, "singular"));
  gsmbp_check ("singular wrist: what is free", ...
    abs (info.free) - [0; 0; 0; 1; 0; 1] / sqrt (2), 1e-8);
  gsmbp_check ("singular wrist: the pose is reached", m.pnt (0, r) - P5, 1e-13);
end

## axes by Euler parameters; a limit that is reached but for rounding
function asked_for (m, q, P, R)
  s = sqrt (1 + trace (R)) / 2;
  e = [s; [R(3,2) - R(2,3); R(1,3) - R(3,1); R(2,1) - R(1,2)] / (4 * s)];
  r = gsmbp_reach (m, "tool", P, 3 * e, "start", q);
  gsmbp_check ("axes by Euler parameters", r - q, 1e-12);
  for k = 1:2
    lim = [-7, 7] .* ones (6, 1);
    lim(2,k) = q(2) + (3 - 2 * k) * 1e-13;
    [r, info] = gsmbp_reach (m, "tool", P, R, "start", q, "limits", lim);
    gsmbp_check ("a limit that is passed by rounding", strcmp (info.status, "ok") ...
                 && r(2) == lim(2,k) && norm (r - q) < 1e-12);
  end
end

## a frame of which the place alone is given: by Newton's method, whatever its axes are then
function place_alone (m, by_formula)
  q = [0.3; -0.5; 0.7; 0.4; 0.8; -0.2];
  P = m.pnt (0, q) + [0.05, -0.3; 0.1, 0.2; -0.02, 0.1];
  [found, info] = gsmbp_reach (m, "tool", P, [], "start", q);
  gsmbp_check ("places alone: reached", strcmp (info.status, "ok"));
  for k = 1:2
    [p, R] = m.pnt (0, found(:,k));
    gsmbp_check ("place alone: the place", p - P(:,k), 1e-12);
  end
  far = m.pnt (0, q) * 5;
  [~, info] = gsmbp_reach (m, "tool", far, [], "start", q);
  gsmbp_check ("place alone, too far: said", strcmp (info.status, "unreachable"));
  said = gsmbp_complaint (@() gsmbp_reach (by_formula, "tool", P));
  gsmbp_check (["place alone without NIK: " said], ! isempty (strfind (said, ...
      "the place of tool has no closed form here: emit the model with the request reach")));
  said = gsmbp_complaint (@() gsmbp_reach (m, "tool", P, [], "method", "closed"));
  gsmbp_check (["place alone by IKN: " said], ...
               ! isempty (strfind (said, "option method: IKN of tool takes its axes too")));
end

function complaints (m, legs)
  said = @(text, f) gsmbp_check (["complaint: " text], ...
      ! isempty (strfind (gsmbp_complaint (f), text)));
  said ('unknown point "tol"', @() gsmbp_reach (m, "tol", [0; 0; 0]));
  said ("places: expected 3 x k", @() gsmbp_reach (m, "tool", [0; 0]));
  said ("axes of pose 1: expected a rotation matrix", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], 2 * eye (3)));
  said ("axes: expected 3 x 3 x 1", @() gsmbp_reach (m, "tool", [0; 0; 0], eye (2)));
  said ("Euler parameters of pose 1 are zero", @() gsmbp_reach (m, "tool", [0; 0; 0], ...
      zeros (4, 1)));
  said ("option limits: expected 6 x 2", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "limits", [1, 2]));
  said ("option limits: q1: the least, 2, is above the largest, 1", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "limits", [2, 1] .* ones (6, 1)));
  said ("option branch: expected one of the 8 branches of IKN (0: any), found 9", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "branch", 9));
  said ("option branch: tool is not reached by a closed form here, which has branches", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "branch", 1, "method", "newton"));
  said ("gsmbp_reach: option start: expected 6 numbers, found 2x1", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "start", [1; 2]));
  said ("option given: no coordinate of this model is given", ...
        @() gsmbp_reach (m, "tool", [0; 0; 0], eye (3), "given", 1));
  said ("option method: IKN was not emitted for plate", ...
        @() gsmbp_reach (legs, "plate", [0; 0; 1], eye (3), "method", "closed"));
end
