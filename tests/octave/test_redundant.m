## More constraints than needed: a plane four-bar of spatial hinges in general position, Bricard's
## six-bar, a parallelogram through its change points; what the scene's description says of it.
## (Hooke: test_reference_hooke; Bennett, a weld, a shaft of two universal joints: test_closures.)

function test_redundant ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  four_bar ();
  bricard ();
  parallelogram ();
  off_the_constraints ();
  plane_by_numbers ();
  mobilities ();
end

function four_bar ()
  m = gsmbp_fixture ("redundant_fourbar");
  gsmbp_check ("redundant four-bar: two rows are left", m.sizes.nlam == 2);
  gsmbp_check ("redundant four-bar: three are reported", numel (m.json.removed) == 3);
  base = pose_go ([0.1; 0.2; 0.3]) * pose_turn (1, 0.3) * pose_turn (2, 0.5);
  place = @(th) places (base, angles (th));
  body = pose_bodies ([0.9, 2.1, 1.4], [0.1, 0.33, 0.26; 0, 0.05, 0; 0.03, -0.02, 0.01], ...
    {[0.004, 0.001, 0; 0.001, 0.006, 0; 0, 0, 0.006], diag([0.02, 0.09, 0.09]), ...
     [0.002, 0, 0.001; 0, 0.03, 0; 0.001, 0, 0.03]});
  gravity = [1; -8; -5];
  [alpha, gap, balance] = deal ([]);
  w = 2;
  for th = [1.1, 2.5, -2, 0.3]
    x = [angles(th); pose_slope(@angles, th) * w];
    gap(:, end+1) = m.con (0, x(1:3));
    [xd, ~] = m.rhs (0, x);
    rest = pose_effort (place, body, gravity, th, w, 0);
    alpha(end+1) = xd(4) + rest / (pose_effort (place, body, gravity, th, w, 1) - rest);
    [y, ~] = m.out (0, x);
    balance(:, end+1) = coupler (m, y, place, body, gravity, th, w, xd(4));
  end
  gsmbp_check ("redundant four-bar: closed, m", gap, 1e-14);
  gsmbp_check ("redundant four-bar: acceleration, rad/s^2", alpha, 1e-8);
  gsmbp_check ("redundant four-bar: Newton and Euler for the coupler, N and N m", balance, 1e-9);
  t = linspace (0, 3, 31);
  r = gsmbp_simulate (m, [angles(1.1); pose_slope(@angles, 1.1) * 2], t, "rtol", 1e-12, "atol", ...
                      1e-12);
  E = arrayfun (@(i) sum (m.ene (0, r.x(i, :)')(1:2)), 1:numel (t));
  gsmbp_check ("redundant four-bar: energy over 3 s, J", E - E(1), 1e-9);
end

## forces and moments of the hinges B and C on the coupler, whatever their share
function e = coupler (m, y, place, body, gravity, th, w, alpha)
  [Fb, Nb] = pose_reaction (m, y, "b");
  [Fc, Nc] = pose_reaction (m, y, "c");
  T = place (th);
  own = @(list) list(:, 2);
  c = @(th) own (pose_centres (place (th), body));
  L = @(th) own (pose_momentum (place, body, th));
  a = pose_bend (c, th) * w ^ 2 + pose_slope (c, th) * alpha;
  turning = pose_slope (L, th) * w ^ 2 + L (th) * alpha;
  B = T(1:3, 4, 2);
  C = (T(:, :, 2) * [0.7; 0; 0; 1])(1:3);
  e = [Fb - Fc + 2.1 * (gravity - a); ...
       Nb - Nc + cross(B - c (th), Fb) - cross(C - c (th), Fc) - turning];
end

function q = angles (th)
  e = [0.6; 0] - 0.25 * [cos(th); sin(th)];
  phi = atan2 (e(2), e(1)) + acos ((0.7 ^ 2 + e' * e - 0.5 ^ 2) / (2 * 0.7 * norm (e)));
  psi = atan2 (0.25 * sin (th) + 0.7 * sin (phi), 0.25 * cos (th) + 0.7 * cos (phi) - 0.6);
  q = [th; phi - th; psi];
end

function T = places (base, q)
  crank = base * pose_turn (3, q(1));
  T = cat (3, crank, crank * pose_go ([0.25; 0; 0]) * pose_turn (3, q(2)), ...
           base * pose_go ([0.6; 0; 0]) * pose_turn (3, q(3)));
end

## Bricard: every other angle a, the others b, with cos(a) + cos(b) + cos(a) cos(b) = 0
function bricard ()
  m = gsmbp_fixture ("redundant_bricard");
  b = @(a) acos (-cos (a) / (1 + cos (a)));
  closed = @(a) [a; b(a); a; b(a); a];
  bar = @(T, angle, tilt) T * pose_go ([1; 0; 0]) * pose_turn (1, tilt) * pose_turn (3, angle);
  place = @(a) bars (closed (a), bar);
  body = pose_bodies (ones (1, 5), repmat ([0.5; 0; 0], 1, 5), ...
                      repmat ({diag([0.001, 1/12, 1/12])}, 1, 5));
  [gap, alpha, spare] = deal ([]);
  w = 1.5;
  for a = [-1.2, -0.6, 0.3, 1, 1.3]
    q = closed (a);
    u = pose_slope (closed, a) * w;
    [phi, phit, H] = m.con (0, q, u);
    gap(:, end+1) = [phi; H * u + phit];
    spare(end+1) = 5 - rank (H, 1e-10);
    [xd, info] = m.rhs (0, [q; u]);
    rest = pose_effort (place, body, [0; -9.81; 0], a, w, 0);
    alpha(end+1) = xd(6) + rest / (pose_effort (place, body, [0; -9.81; 0], a, w, 1) - rest);
  end
  gsmbp_check ("Bricard: closed", gap, 1e-10);
  gsmbp_check ("Bricard: rank four of five rows, one freedom", spare == 1);
  gsmbp_check ("Bricard: lost rank is reported", info == 2);
  gsmbp_check ("Bricard: acceleration, rad/s^2", alpha, 1e-9);
  t = linspace (0, 10, 101);
  r = gsmbp_simulate (m, [closed(1); zeros(5, 1)], t, "rtol", 1e-11, "atol", 1e-11, "maxsteps", ...
                      500000);
  E = cell2mat (arrayfun (@(i) m.ene (0, r.x(i, :)')(1:2)(:), 1:numel (t), "UniformOutput", false));
  total = sum (E, 1);
  exchanged = max (E(2, :)) - min (E(2, :));
  printf ("   (angle between %.2f and %.2f rad, %.0f J exchanged)\n", min (r.x(:, 1)), ...
          max (r.x(:, 1)), exchanged);
  ## smooth motion: the step control must not see a rank that comes and goes
  gsmbp_check (sprintf ("Bricard: %d steps for 10 s", r.stats.accepted + r.stats.rejected), ...
               r.stats.accepted + r.stats.rejected < 3000);
  gsmbp_check ("Bricard: energy over 10 s, of what is exchanged", ...
               (total - total(1)) / exchanged, 1e-8);
  gsmbp_check ("Bricard: drift over 10 s, m", r.stats.drift.phi, 1e-10);
  gsmbp_check ("Bricard: cos(a) + cos(b) + cos(a) cos(b)", ...
               cos (r.x(:, 1)) + cos (r.x(:, 2)) + cos (r.x(:, 1)) .* cos (r.x(:, 2)), 1e-9);
  gsmbp_check ("Bricard: angles of a kind stay equal", ...
               sin ([r.x(:, [3, 5]) - r.x(:, 1), r.x(:, 4) - r.x(:, 2)]), 1e-8);
end

function T = bars (q, bar)
  T = pose_turn (3, q(1));
  for k = 2:5
    T(:, :, k) = bar (T(:, :, k - 1), q(k), pi / 2 * (-1) ^ k);
  end
end

## q1 = q3 = -q2: (I of both cranks and of the bar's mass) a = moment of the weights; at rest in a
## dead line is another story: it moves
function parallelogram ()
  m = gsmbp_fixture ("redundant_parallel");
  I = 2 * (0.0075 + 0.15 ^ 2) + 2 * 0.3 ^ 2;
  pull = 9.81 * (2 * 0.15 + 2 * 0.3);
  alpha = [];
  for a = [0.2, 1, 2.5, pi, 0]   # the last two in one line
    [xd, info] = m.rhs (0, [a; -a; a; 4; -4; 4]);
    alpha(end+1) = xd(4) + pull * cos (a) / I;
  end
  gsmbp_check ("parallelogram: acceleration away from its dead lines, rad/s^2", alpha(1:3), 1e-11);
  gsmbp_check ("parallelogram: in a line the lost rank is reported", info == 2);
  t = linspace (0, 5, 51);
  warning ("off", "gsmbp:singular", "local");
  r = gsmbp_simulate (m, [1; -1; 1; 12; -12; 12], t, "rtol", 1e-11, "atol", 1e-11);
  E = arrayfun (@(i) sum (m.ene (0, r.x(i, :)')(1:2)), 1:numel (t));
  printf ("   (%.0f half turns)\n", (r.x(end, 1) - 1) / pi);
  gsmbp_check ("parallelogram: stays one through its change points", ...
               [r.x(:, 3) - r.x(:, 1), r.x(:, 2) + r.x(:, 1)], 1e-6);
  gsmbp_check ("parallelogram: its change points are reported", r.stats.singular_positions >= 20);
  gsmbp_check ("parallelogram: energy over 5 s, relative", E / E(1) - 1, 1e-8);
end

## a state that is off the constraints by 1e-15 to 1e-5: rows that are dependent on the constraints
## are off that by as much; accelerations may be wrong by no more than their change over that
## distance, some tens of times it (bars of 0.2 to 1 m, speeds of 1 rad/s, Baumgarte's terms)
function off_the_constraints ()
  rand ("twister", 7);
  randn ("twister", 7);
  for c = {"redundant_bricard", "close_revolute", "redundant_tilted", "redundant_fourbar", ...
           "redundant_parallel", "case_09a", "close_spherical"}
    m = gsmbp_fixture (c{1});
    d = m.sizes;
    speeds = d.nq + (1:d.nu);
    wrong = zeros (4, 0);
    infos = [];
    for k = 1:5
      x = gsmbp_assemble (m, m.initial);
      x(speeds) += 2 * rand (d.nu, 1) - 1;
      x = gsmbp_simulate (m, m.prj (0, x), [0, 0.02 * k]).x(2,:)';
      [xd, info] = m.rhs (0, x);
      for off = 10 .^ (-15:-5)
        near = x + off * randn (d.nx, 1);
        for way = 1:4
          [ud, ~, i] = m.acd (0, near, zeros (d.nv, 1), way);
          wrong(way,end+1) = norm (ud - xd(speeds)) / norm (xd(speeds)) / off;
        end
        [nd, i] = m.rhs (0, near);
        wrong(1,end+1) = norm ((nd - xd)(speeds)) / norm (xd(speeds)) / off;
        infos(end+1) = i - info;
      end
    end
    gsmbp_check (sprintf (["%s off its constraints: error of m.rhs and of m.acd by four ways, " ...
                           "beside " ...
                           "the distance"], c{1}), wrong, 200);
    gsmbp_check (sprintf ("%s off its constraints: INFO as on them", c{1}), infos, 0);
  end
  for c = {"redundant_bricard", "redundant_tilted"; 10, 3}
    m = gsmbp_fixture (c{1});
    x = gsmbp_assemble (m, m.initial);
    for rtol = [1e-6, 1e-9]
      b = gsmbp_simulate (m, x, 0:0.1:c{2}, "loops", "baumgarte", "rtol", rtol);
      p = gsmbp_simulate (m, x, 0:0.1:c{2}, "rtol", rtol);
      E = cell2mat (arrayfun (@(i) m.ene (0, b.x(i,:)')(1:2), 1:numel (b.t), "UniformOutput", ...
                              false));
      gsmbp_check (sprintf ("%s, baumgarte, rtol %.0e: %d calls, by projection %d", c{1}, rtol, ...
                            b.stats.calls, p.stats.calls), b.stats.calls < 4 * p.stats.calls);
      gsmbp_check (sprintf ("%s, baumgarte, rtol %.0e: energy, of what is exchanged", c{1}, ...
                            rtol), (sum (E) - sum (E)(1)) / range (E(2,:)), 100 * rtol);
      gsmbp_check (sprintf ("%s, baumgarte, rtol %.0e: the motion is that by projection, rad", ...
                            c{1}, rtol), b.x(:,1) - p.x(:,1), 1e3 * rtol);
    end
  end
end

## a plane four-bar that is plane only by the numbers of its parameters: against the one whose rows
## could be left out before
function plane_by_numbers ()
  m = gsmbp_fixture ("redundant_tilted");
  gsmbp_check ("plane by numbers: no row is left out before", m.sizes.nlam - 5, 0);
  x = gsmbp_assemble (m, m.initial);
  for way = {"projection", "partitioning", "nullspace", "svd", "kane"}
    r = gsmbp_simulate (m, x, 0:0.05:10, "loops", way{1}, "rtol", 1e-10);
    E = cell2mat (arrayfun (@(i) m.ene (0, r.x(i,:)')(1:2), 1:numel (r.t), "UniformOutput", false));
    gsmbp_check (sprintf ("plane by numbers, %s: energy over 10 s, of what is exchanged", ...
                          way{1}), (sum (E) - sum (E)(1)) / range (E(2,:)), 1e-8);
    gsmbp_check (sprintf ("plane by numbers, %s: closed, m", way{1}), r.stats.drift.phi, 1e-14);
  end
  ## axes that the numbers make parallel to 1e-7 only
  [xd, ~] = m.rhs (0, x);
  m = gsmbp_set (m, "be", -0.3 + 1e-7);
  [nd, info] = m.rhs (0, x);
  gsmbp_check ("plane by numbers, axes 1e-7 rad from parallel: acceleration", ...
               [norm(nd - xd) / norm(xd), info - 2], 1e-6);
end

## freedoms by Gruebler's count and true ones
function mobilities ()
  for c = ...
      {"case_03a", -2, 1; "redundant_fourbar", -2, 1; "redundant_tilted", -2, 1; ...
       "redundant_bricard", 0, 1; "close_revolute", -2, 1; "close_universal", 0, 1; "case_09a", ...
           -2, 1; ...
           "close_fixed", -4, 1; "close_planar", 2, 2; "case_04", -8, 1}'
    m = gsmbp_fixture (c{1});
    gsmbp_check (sprintf ("mobility of %s: %d by Gruebler, %d true", c{:}), ...
                 m.json.mobility.gruebler == c{2} && m.json.mobility.true == c{3});
  end
end
