## Assembly with coordinates held stays on the branch of its guess: from closed poses of six
## linkages the held coordinates are moved by a step, the others are left as they were. Poses on
## both branches are closed forms. GSMBP_WHOLE: 72 starts for every step.

function test_branches ()
  warning ("off", "gsmbp:singular", "local");
  whole = ! isempty (getenv ("GSMBP_WHOLE"));
  steps = [30, 35, 40, 45, 60, 90, -90];
  for s = linkages ()
    if (whole)
      arrayfun (@(step) starts (s, step, 72), steps(abs (steps) <= s.most));
    else
      starts (s, s.most, s.count);
    end
  end
  first_seen ();
  unreached ();
  ends ();
  beyond_limits ();
end

## models, their held coordinates, poses by the angle of the first and the branch +-1, its range
## and the largest step [deg], starts of the short test.  Forks of Hooke's joints fit half a turn
## on, too: a step of 90 deg has no nearer branch.
function s = linkages ()
  bar = gsmbp_hand ("hand_fourbar");
  rocker = gsmbp_set (bar, "l1", 0.5, "l2", 1.2, "l3", 0.8, "l4", 1);
  drag = gsmbp_set (bar, "l1", 0.6, "l2", 0.7, "l3", 0.7, "l4", 0.3);
  crank = gsmbp_hand ("hand_crank");
  bricards = gsmbp_fixture ("redundant_bricard");
  fives = gsmbp_fixture ("control_fivebar");
  s = struct ("name", {"crank-rocker", "double crank", "slider-crank", "Bricard's six-bar", ...
                       "five-bar", "two Hooke's joints"}, ...
              "m", {rocker, drag, crank, bricards, fives, gsmbp_fixture("close_universal")}, ...
              "held", {{"q1"}, {"q1"}, {"q1"}, {"q1"}, {"q1", "q2"}, {"theta"}}, ...
              "pose", {@(a, b) four_bar(rocker.par, a, b), @(a, b) four_bar(drag.par, a, b), ...
                       @(a, b) slider_crank(crank.par, a, b), @bricard, @five_bar, @hooke}, ...
              "range", {[0 360], [0 360], [0 360], [-110 110], [40 230], [0 360]}, ...
              "most", {90, 90, 90, 90, 90, 60}, "count", {24, 8, 8, 6, 6, 6});
end

function q = four_bar (p, a, b)
  B = p.l1 * exp (1i * a);
  q3 = second (B - p.l4, p.l3, p.l2, b);
  q = [a; arg(p.l4 + p.l3 * exp (1i * q3) - B); q3];
end

## the direction of a bar of length L from 0, whose end is R away from the point P
function angle = second (p, l, r, b)
  angle = arg (p) + b * acos ((l^2 + abs (p)^2 - r^2) / (2 * l * abs (p)));
end

function q = slider_crank (p, a, b)
  q2 = asin (-p.l1 / p.l2 * sin (a));
  if (b < 0)
    q2 = pi - q2;
  end
  q = [a; q2; p.l1 * cos(a) + p.l2 * cos(q2)];
end

## cos(a) + cos(b) + cos(a)*cos(b) = 0
function q = bricard (a, b)
  other = b * acos (-cos (a) / (1 + cos (a)));
  q = [a; other; a; other; a];
end

function q = five_bar (a, b)
  q2 = a - 0.9;
  A = 0.3 * exp (1i * a);
  C = 0.2 + 0.3 * exp (1i * q2);
  p2 = second (A - C, 0.4, 0.4, b);
  q = [a; arg(C + 0.4 * exp (1i * p2) - A) - a; q2; p2 - q2];
end

## two universal joints, bends of 30 and 45 deg; on the other branch the driven fork is turned over
function q = hooke (a, b)
  bend = pi / 6;
  q = [a; atan(tan(bend)*cos(a))-bend; asin(sin(bend)*sin(a)); ...
       arg(cos(a)+1i*sin(a)*cos(bend)/cos(pi/4)) + pi*(b<0)];
end

## COUNT starts on both branches, each a step of the held coordinates [deg] away from a closed pose
function starts (s, step, count)
  k = cellfun (@(name) find (strcmp (s.m.coordinates, name)), s.held);
  range = s.range;
  if (diff (range) < 360)
    range = [max(range(1), range(1) - step), min(range(2), range(2) - step)];
  end
  wrong = 0;
  for i = 1:count
    a = pi / 180 * (range(1) + diff (range) * i / count);
    for b = [-1, 1]
      right = s.pose (a + pi / 180 * step, b);
      guess = s.pose (a, b);
      guess(k) = right(k);
      wrong += ! (error_of (s, guess, right) < 1e-7);
    end
  end
  gsmbp_check (sprintf ("%s: %d starts on each of two branches, steps of %d deg: wrong ones", ...
                        s.name, count, step), wrong, 0);
end

## NaN where there is an error
function e = error_of (s, guess, right)
  e = NaN;
  try
    off = gsmbp_assemble (s.m, guess, "hold", s.held)(1:s.m.sizes.nq) - right;
    turning = strcmp (s.m.units.coordinates, "rad");
    off(turning) = angle (exp (1i * off(turning)));
    e = max (abs (off));
  end
end

## the first start that ended on the mirror branch; the coordinates are not those of hand_fourbar
function first_seen ()
  m = gsmbp_set (gsmbp_hand ("hand_fourbar"), "l1", 0.5, "l2", 1.2, "l3", 0.8, "l4", 1);
  x = gsmbp_assemble (m, [1.1345, 1.1345 - 0.3890, 0.7595], "hold", "q1");
  gsmbp_check ("mirror branch of the crank-rocker: the rocker at 1.0681 rad", x(3) - 1.0681, 5e-5);
end

## a held value out of reach: the end of the branch, where two bars are in one line; coordinates
## that may not be held
function unreached ()
  m = gsmbp_hand ("hand_crank");
  ended (m, {"q3", 5}, "most", 0.5 + 0.2);
  ended (m, {"q3", -5}, "least", 0.5 - 0.2);
  m = gsmbp_set (gsmbp_hand ("hand_fourbar"), "l1", 0.5, "l2", 1.2, "l3", 0.8, "l4", 1);
  angle = @(reach) acos ((reach^2 - 1 - 0.8^2) / (2 * 0.8));
  ended (m, {"q3", 3.1}, "most", angle (1.2 - 0.5));
  ended (m, {"q3", 0.1}, "least", angle (1.2 + 0.5));
  says (m, {"q1", 1, "q3", 1}, ["option hold: the loops leave 1 degree(s) of freedom to q1, " ...
                                "q3; expected at most as many coordinates to hold, found 2"]);
  m = gsmbp_fixture ("driven_fourbar");
  driven = "option hold: theta is driven (phi of A.motion), at the time 0 to 1.1; ";
  says (m, {"theta", 2}, [driven "found 2; leave it out of hold, or take another time (option " ...
                          "time)"]);
  says (m, {"beta", -0.5}, "beta is fixed by the constraints, at the time 0 to -0.7376");
end

function ended (m, held, word, value)
  text = says (m, held, sprintf ("option hold: expected %s at %s ", held{1}, word));
  found = regexp (text, "at (least|most) ([-\\d.]+), where the branch of the guess ends", "tokens");
  gsmbp_check ("... the end", str2double (found{1}{2}) - value, 2e-5);
end

function text = says (m, held, said)
  x = gsmbp_assemble (m, m.initial);
  for k = 1:2:numel (held)
    x(strcmp (m.coordinates, held{k})) = held{k+1};
  end
  text = gsmbp_complaint (@() gsmbp_assemble (m, x, "hold", held(1:2:end)));
  gsmbp_check (text, ! isempty (strfind (text, said)));
end

## a rod shorter than the crank: q1 = 2.8 is on another branch than q1 = 0
function ends ()
  m = gsmbp_set (gsmbp_hand ("hand_crank"), "l2", 0.1);
  text = gsmbp_complaint (@() gsmbp_assemble (m, [2.8; 0; 0.3], "hold", "q1"));
  gsmbp_check (["a branch that ends: " text], ! isempty (regexp (text, ["expected q1 = 2\\.8 " ...
    "on the branch of the guess; found its end at q1 = 0\\.52[0-9]*; .*\"branches\""])));
  text = gsmbp_complaint (@() gsmbp_assemble (m, [1; 0; 0.3], "hold", "q1"));
  gsmbp_check (["no branch at all: " text], ! isempty (regexp (text, ["option hold: expected " ...
    "q1 at most 0\\.5235[0-9]*, where the branch of the guess ends; found 1, .*\"branches\""])));
  X = gsmbp_assemble (m, [2.8; 0; 0.3], "hold", "q1", "branches", 20);
  gsmbp_check ("\"branches\" gives both poses at q1 = 2.8", sort (X(3,:)) ...
               - 0.2 * cos (2.8) - sqrt (0.01 - 0.04 * sin (2.8)^2) * [-1, 1], 1e-12);
end

## a held value beyond the limits of its joint, where the loop closes: the pose, and a warning
function beyond_limits ()
  m = gsmbp_fixture ("free_crank");
  limit = 150 * pi / 180;
  for q1 = [limit, -limit, limit * (1 + 1e-9), -2.8, 2 * pi]
    lastwarn ("");
    x = gsmbp_assemble (m, [q1; 0; 0.5], "hold", "q1");
    wanted = sprintf ("q1 = %.6g rad is outside the limits of its joint; expected -2.61799", q1);
    warns = ! isempty (strfind (lastwarn (), wanted));
    gsmbp_check (sprintf ("held at %.10g rad, limit 150 deg", q1), ...
                 (x(1:3) - slider_crank (m.par, q1, 1))([1 3]), 1e-9);
    gsmbp_check (["... " lastwarn()], warns == (abs (q1) > limit));
  end
  lastwarn ("");
  gsmbp_assemble (m, [2.8; 0; 0.5]);
  gsmbp_check ("not held: no warning", isempty (lastwarn ()));
  X = gsmbp_assemble (m, [2.8; 0; 0.5], "hold", "q1", "branches", 20);
  gsmbp_check (["both branches, one warning: " lastwarn()], columns (X) == 2 ...
               && ! isempty (strfind (lastwarn (), "q1 = 2.8 rad is outside")));
end
