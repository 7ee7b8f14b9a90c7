## [t, x, force, f, ud, wrong] = stewart_plan (M): the planned motion of the platform, 6 s in steps
## of 5 ms: states (rows), forces of the drives (rows), pose with its rates and accelerations (6 x
## times x 3), accelerations of the scene (rows); wrong: gaps of the loops, differences from the
## closed form.
##
## Up by 5 cm, twice round a circle of 10 cm leaning inwards by 10 degrees, back; the motion is the
## cubic spline through knots each 50 ms.

function [t, x, force, f, ud, wrong] = stewart_plan (m)
  knots = 0:0.05:6;
  blend = gsmbp_evaluate (gsmbp_plan ("septic", [0 1 1 0], [0.5 1.5 4.5 5.5]), knots);
  turns = 2 * pi * 2 * gsmbp_evaluate (gsmbp_plan ("septic", [0 1], [0.75 5.25]), knots);
  lean = 10 * pi / 180;
  plan = gsmbp_plan ("table", knots, [0.1 * blend .* cos(turns); 0.1 * blend ...
      .* sin(turns); m.par.h + 0.05 * blend; ...
                                      lean * blend .* sin(turns); -lean * blend ...
                                          .* cos(turns); zeros(1, numel (knots))]', 3);
  t = (0:0.005:6)';
  f = gsmbp_evaluate (plan, t, 2);
  drives = zeros (24, 6);
  drives(9:3:24,:) = eye (6);
  for k = 1:numel (t)
    [q, u, ud(k,:), wrong(k,:)] = whole (m, f(:,k,1), f(:,k,2), f(:,k,3));
    [~, ~, H] = m.con (t(k), q, u);
    ## tree's efforts = drives' + H' lambda
    solved = [drives, H'] \ m.inv (t(k), q, u, ud(k,:)', zeros (6, 1));
    x(k,:) = [q; u];
    force(k,:) = solved(1:6);
  endfor
endfunction

## coordinates, speeds and accelerations of the whole scene for a motion of the platform; the legs'
## rates from the constraints
function [q, u, ud, wrong] = whole (m, pose, rate, acc)
  [e, w, wd] = stewart_turning (pose, rate, acc);
  [legs, sd, sdd] = stewart_legs (m.par, pose, rate, acc);
  q = [pose(1:3); e; legs(:)];
  u = [rate(1:3); w; zeros(18, 1)];
  ud = [acc(1:3); wd; zeros(18, 1)];
  [~, ~, H] = m.con (0, q, u);
  u(7:24) = -H(:,7:24) \ (H(:,1:6) * u(1:6));
  [phi, ~, H, gam] = m.con (0, q, u);
  ud(7:24) = H(:,7:24) \ (gam - H(:,1:6) * ud(1:6));
  wrong = [max(abs (phi)), max(abs (u(9:3:24) - sd)), max(abs (ud(9:3:24) - sdd))];
endfunction
