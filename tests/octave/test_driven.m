## A driven crank: the four-bar follows the law of time, and the drive's effort is that of the
## closed form. (A driven pivot: test_reference_driven_pivot.)

function test_driven ()
  addpath (fullfile (fileparts (mfilename ("fullpath")), "poses"));
  m = gsmbp_fixture ("driven_fourbar");
  law = @(t) [1.1 + 5 * t + 0.3 * sin(7 * t); 5 + 2.1 * cos(7 * t); -14.7 * sin(7 * t)];
  place = @(th) places (th);
  angles = @(th) [th; phi_of(th) - th; psi_of(th)];
  body = pose_bodies ([0.9, 2.1, 1.4], [0.1, 0.33, 0.26; 0, 0.05, 0; 0, 0, 0], ...
                      {diag([0, 0.006, 0.006]), diag([0, 0.09, 0.09]), diag([0, 0.03, 0.03])});
  drive = strcmp (m.multipliers, "A.motion");
  gsmbp_check ("driven: the drive has a multiplier", sum (drive) == 1);
  gsmbp_check ("driven: no freedom is left", m.json.mobility.true == 0);
  [gap, ud_error, effort, moment] = deal ([]);
  for t = [0, 0.2, 0.5, 0.77, 1.1]
    [th, w, alpha] = num2cell (law (t)){:};
    q = angles (th);
    u = pose_slope (angles, th) * w;
    ud = pose_bend (angles, th) * w ^ 2 + pose_slope (angles, th) * alpha;
    [phi, phit, H, gam] = m.con (t, q, u);
    gap(:, end+1) = [phi; (H * u + phit) / norm(u); (H * ud - gam) / norm(ud)];
    [found, lam] = m.acc (t, [q; u], []);
    ud_error(:, end+1) = (found - ud) / norm (ud);
    wanted = pose_effort (place, body, [0; -9.81; 0], th, w, alpha);
    effort(end+1) = (lam(drive) - wanted) / max (1, abs (wanted));
    [~, N] = pose_reaction (m, m.out (t, [q; u]), "a");
    moment(end+1) = N(3) - lam(drive);
  end
  gsmbp_check ("driven: positions, speeds, accelerations of the closed form", gap, 1e-10);
  gsmbp_check ("driven: accelerations", ud_error, 1e-10);
  gsmbp_check ("driven: effort of the drive", effort, 1e-9);
  gsmbp_check ("driven: it is the moment in the crank's bearing", moment, 1e-11);
  ## the drive is all that gives power: u.H' lambda is its effort times its speed (RHA)
  r = gsmbp_simulate (m, [angles(1.1); pose_slope(angles, 1.1) * 7.1], linspace (0, 2, 41), ...
                      "rtol", 1e-11, "audit", 1);
  gsmbp_check ("driven: energy passes through the drive, J", r.audit.passed(end) > 1);
  gsmbp_check ("driven: energy audit", r.audit.error, 1e-8);
  t = linspace (0, 2, 41)';
  for way = {"projection", "baumgarte", "partitioning"}
    r = gsmbp_simulate (m, [angles(1.1); pose_slope(angles, 1.1) * 7.1], t, "rtol", 1e-11, ...
                        "atol", 1e-11, "loops", way{1});
    for i = 1:numel (t)
      away(i, :) = sin (r.x(i, 1:3)' - angles (law (t(i))(1)));
    end
    gsmbp_check (["driven: follows the law over 2 s, " way{1}], away, 1e-8);
  end
end

function T = places (th)
  [phi, psi, B] = deal (phi_of (th), psi_of (th), 0.25 * [cos(th); sin(th); 0]);
  T = cat (3, pose_turn (3, th), pose_go (B) * pose_turn (3, phi), ...
           pose_go ([0.6; 0; 0]) * pose_turn (3, psi));
end

function phi = phi_of (th)
  e = [0.6; 0] - 0.25 * [cos(th); sin(th)];
  phi = atan2 (e(2), e(1)) + acos ((0.7 ^ 2 + e' * e - 0.5 ^ 2) / (2 * 0.7 * norm (e)));
end

function psi = psi_of (th)
  phi = phi_of (th);
  psi = atan2 (0.25 * sin (th) + 0.7 * sin (phi), 0.25 * cos (th) + 0.7 * cos (phi) - 0.6);
end
