## Forces and moments in the joints against Newton's and Euler's laws, body by body from poses
## (poses/pose_*.m), against closed forms and the reference four-bar; the same four-bar cut at one
## pin, at another, through its coupler.

function test_reactions ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  chain ();
  bracket ();
  four_bars ();
end

## From the last link to the first: force F and moment N (about the joint's point) that a link gets
## from the side of the ground.
function chain ()
  m = gsmbp_fixture ("react_chain");
  time = 0.4;
  [q, u] = deal ([0.3; -0.1; 1.1; 0.7; -0.4; 0.2], [2; 0.5; -3; 1; 2; -0.7]);
  xd = m.rhs (time, [q; u]);
  y = m.out (time, [q; u]);
  ## slow motion, for the differences
  at = @(s) chain_places (q + u * s / 5 + xd(7:12) * (s / 5) ^ 2 / 2);
  body = pose_bodies ([2, 1.5, 1, 0.7, 0.4], [0.1, 0.2, -0.1, 0.05, 0; 0.05, -0.1, 0, 0.1, 0.02; ...
      0.2, 0, 0.15, -0.1, 0.1], ...
    {[0.03, 0.005, -0.004; 0.005, 0.04, 0; -0.004, 0, 0.02], [0.02, 0, 0; 0, 0.03, 0.003; 0, ...
        0.003, 0.04], ...
     [0.01, 0.002, 0; 0.002, 0.02, 0.001; 0, 0.001, 0.015], [0.01, 0, 0.001; 0, 0.01, 0; 0.001, ...
         0, 0.012], diag([0.004, 0.003, 0.002])});
  [T, stands] = at (0);
  acceleration = 25 * pose_bend (@(s) pose_centres (at (s), body), 0);
  turning = 25 * pose_slope (@(s) pose_momentum (at, body, s), 0);
  c = pose_centres (T, body);
  R = @(k) T(1:3, 1:3, k);
  [F, N] = deal (zeros (3, 6));
  for k = 5:-1:1
    [f, n] = deal (body(k).mass * (acceleration(:, k) - [0; -3; -9]), turning(:, k));
    if (k == 5)
      push = R (5) * [5 * time; -2; 1];
      f -= push;
      n -= cross (R (5) * ([0.1; 0; 0.1] - body(5).centre), push);
    elseif (k == 3)
      n -= [0.3; 0; -0.2];
    end
    F(:, k) = f + F(:, k + 1);
    N(:, k) = n + N(:, k + 1) + cross (c(:, k) - stands(:, k), f);
    if (k < 5)
      N(:, k) += cross (stands(:, k + 1) - stands(:, k), F(:, k + 1));
    end
  end
  ## the third joint is drawn from c to b: what c gives to b
  F(:, 3) *= -1;
  N(:, 3) *= -1;
  for k = 1:5
    [f, n] = pose_reaction (m, y, sprintf ("r%d", k));
    gsmbp_check (sprintf ("reactions: joint J%d of the chain, force, of %.0f N", k, ...
                          norm (F(:, k))), f - F(:, k), 1e-9);
    gsmbp_check (sprintf ("reactions: joint J%d of the chain, moment, of %.1f N m", k, ...
                          norm (N(:, k))), n - N(:, k), 1e-9);
  end
  [f, n] = pose_reaction (m, y, "p2");
  gsmbp_check ("reactions: the same in the axes of the parent", ...
               [R(1) * f - F(:, 2), R(1) * n - N(:, 2)], 1e-9);
  [f, n] = pose_reaction (m, y, "c2");
  gsmbp_check ("reactions: and in those of the child", [R(2) * f - F(:, 2), R(2) * n - N(:, 2)], ...
               1e-9);
end

## placements of the five links, and where their joints stand
function [T, stands] = chain_places (q)
  A = pose_go ([0.1; 0; 0.2]) * pose_turn ([1; 0; 1] / sqrt (2), q(1));
  J2 = A * pose_go ([0.2; 0.1; 0.3]) * pose_turn (1, 0.5) * pose_go ([0; 0; q(2)]) ...
      * pose_turn (3, q(3));
  B = J2 * pose_go ([0; -0.1; 0]);
  J3 = B * pose_go ([0.4; 0; 0.1]);
  C = J3 * pose_turn (2, -q(5)) * pose_turn (1, -q(4)) * pose_go ([0.2; 0; 0]);
  D = C * pose_go ([0; 0; 0.3]) * pose_turn (2, -0.7) * pose_go ([1; 2; 2] / 3 * q(6));
  J5 = D * pose_go ([0.1; 0.2; 0]);
  E = J5 * pose_turn (3, 0.3) * pose_go ([0; 0; 0.05]);
  T = cat (3, A, B, C, D, E);
  stands = [A(1:3, 4), J2(1:3, 4), J3(1:3, 4), D(1:3, 4), J5(1:3, 4)];
end

## a pendulum pulls with m (g cos(q) + c w^2) along and m g sin(q) j/(j + m c^2) across its rod; its
## bracket carries this and its own weight
function bracket ()
  m = gsmbp_fixture ("react_bracket");
  [g, mb, mr, c, j] = deal (9.81, 3, 2, 0.4, 0.05);
  [found, wanted, wall] = deal ([]);
  for s = [0, 0; 0.7, 0; 2.5, 3; -1, -6]'
    [q, w] = deal (s(1), s(2));
    y = m.out (0, [q; w]);
    [f, n] = pose_reaction (m, y, "along");
    pull = mr * (g * cos (q) + c * w ^ 2);
    across = mr * g * sin (q) * j / (j + mr * c ^ 2);
    found(:, end+1) = [f; n];
    wanted(:, end+1) = [-across; 0; pull; 0; 0; 0];
    [F, N] = pose_reaction (m, y, "w");
    p = pose_turn (2, q)(1:3, 1:3) * [-across; 0; pull];
    wall(:, end+1) = [F; N] ...
        - [p + [0; 0; mb * g]; cross([0.5; 0.2; 0], p) + cross([0.2; 0.1; 0], [0; 0; mb * g])];
  end
  gsmbp_check ("reactions: pendulum, pull along and force across the rod", found - wanted, 1e-13);
  gsmbp_check ("reactions: the bracket's load on the wall", wall, 1e-13);
end

function four_bars ()
  [~, ~, tab] = gsmbp_case ("03a_fourbar");
  [th, phi, psi] = deal (tab.theta, tab.phi_coupler, tab.psi_rocker);
  models = {"react_cut_c", [th, phi - th, psi]; "react_cut_b", [th, psi, psi - phi]; ...
            "react_link", [th, phi - th, psi, psi - phi]};
  pins = zeros (rows (th), 12, 3);
  for k = 1:3
    m = gsmbp_fixture (models{k, 1});
    alpha = closed = zeros (rows (th), 1);
    for i = 1:rows (th)
      x = state (m, models{k, 2}(i, :)', tab.omega(i));
      closed(i) = norm (m.con (0, x(1:m.sizes.nq)));
      xd = m.rhs (0, x);
      alpha(i) = xd(m.sizes.nq + 1);
      y = m.out (0, x);
      for pin = 1:4
        [F, N] = pose_reaction (m, y, "abcd"(pin));
        pins(i, 3 * pin - (2:-1:0), k) = [F(1:2)', N(3)];
        out_of_plane(i, pin) = norm ([F(3); N(1:2)]);
      end
    end
    gsmbp_check ([models{k, 1} ": closed at the reference positions, m"], closed, 1e-14);
    gsmbp_check ([models{k, 1} ": crank acceleration of the reference"], ...
                 (alpha - tab.alpha) / max (abs (tab.alpha)), 1e-12);
    gsmbp_check ([models{k, 1} ": pin force of the reference"], ...
                 (pins(:, 7:8, k) - [tab.lam_x, tab.lam_y]) / max (abs ([tab.lam_x; ...
                       tab.lam_y])), 1e-12);
    gsmbp_check ([models{k, 1} ": no moment in the pins, nothing out of the plane"], ...
                 [pins(:, 3:3:12, k), out_of_plane], 1e-12);
    x = gsmbp_run (m, tab.t, state (m, models{k, 2}(1, :)', tab.omega(1)), []);
    ## as in the reference case: an error at the start grows by a few hundred over 3 s
    gsmbp_check ([models{k, 1} ": motion over 3 s, rad"], x(:, 1:m.sizes.nq) - models{k, 2}, 1e-9);
  end
  size = max (abs (pins(:)));
  gsmbp_check ("reactions: all four pins, cut at B as cut at C", ...
               (pins(:, :, 2) - pins(:, :, 1)) / size, 1e-12);
  gsmbp_check ("reactions: all four pins, through the coupler as at C", ...
               (pins(:, :, 3) - pins(:, :, 1)) / size, 1e-12);
  whole (pins(1, :, 1), tab);
end

## forces on the whole: A + D + weights = rate of momentum, from the closed form of the four-bar
function whole (pin, tab)
  [la, lb, lc, ld] = deal (0.25, 0.7, 0.5, 0.6);
  place = @(th) four_bar_places (th, la, lb, lc, ld);
  body = pose_bodies ([0.9, 2.1, 1.4], [0.1, 0.33, 0.26; 0, 0.05, 0; 0, 0, 0], ...
                      {zeros(3), zeros(3), zeros(3)});
  c = @(th) pose_centres (place (th), body);
  [th, w, alpha] = deal (tab.theta(1), tab.omega(1), tab.alpha(1));
  a = pose_bend (c, th) * w ^ 2 + pose_slope (c, th) * alpha;
  force = a * [body.mass]' - sum ([body.mass]) * [0; -9.81; 0];
  gsmbp_check ("reactions: momentum of the whole four-bar, N", ...
               pin(1:2)' + pin(10:11)' - force(1:2), 1e-9);
end

function T = four_bar_places (th, la, lb, lc, ld)
  B = la * [cos(th); sin(th)];
  e = [ld; 0] - B;
  phi = atan2 (e(2), e(1)) + acos ((lb ^ 2 + e' * e - lc ^ 2) / (2 * lb * norm (e)));
  C = B + lb * [cos(phi); sin(phi)];
  psi = atan2 (C(2), C(1) - ld);
  T = cat (3, pose_turn (3, th), pose_go ([B; 0]) * pose_turn (3, phi), ...
           pose_go ([ld; 0; 0]) * pose_turn (3, psi));
end

## speeds from that of the crank
function x = state (m, q, w)
  [~, ~, H] = m.con (0, q, zeros (numel (q), 1));
  x = [q; w; -H(:, 2:end) \ H(:, 1) * w];
end
