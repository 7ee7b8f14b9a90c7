## A car on four tyres: straight running against the linear single-track model, its critical speed
## with the mass behind; a steady turn against the balance of its forces; lane and speed held by
## controllers with samples, delay and limits about both motions, and where that fails.

function test_car ()
  pkg load control
  m = gsmbp_fixture ("steady_car");
  straight (m);
  critical (m);
  e = turn (m);
  lane (m);
  round_and_round (m, e);
end

function [e, sys] = at_speed (m, v, drop)
  x = m.initial;
  x(4) = v;
  e = gsmbp_trim (m, x, [0; 0], "steady", "x");
  said = warning ("off", "all");
  sys = gsmbp_linear (m, 0, e.x, e.v, "drop", drop);
  warning (said);
end

## m (vy' + v r) = Ff + Fr, j r' = a Ff - b Fr
function straight (m)
  p = m.par;
  v = 20;
  [~, sys] = at_speed (m, v, {"x", "y", "yaw"});
  C = 2 * p.c;
  A = [-2*C/(p.m*v), -v - C*(p.a - p.b)/(p.m*v)
       -C*(p.a - p.b)/(p.j*v), -C*(p.a^2 + p.b^2)/(p.j*v)];
  B = [C/p.m, 0; C*p.a/p.j, 0];
  gsmbp_check ("car, straight on: the single-track model", ...
               [sys.a(2:3,2:3) - A, sys.b(2:3,:) - B], 1e-11);
  gsmbp_check ("car, straight on: its speed apart", ...
               [sys.a(1,:), sys.a(:,1)', sys.b(1,:) - [0, 1/p.m]], 1e-15);
end

## with the mass nearer to the rear axle it goes round by itself above sqrt(L/|K|)
function critical (m)
  back = gsmbp_set (m, "a", m.par.b, "b", m.par.a);
  p = back.par;
  L = p.a + p.b;
  limit = sqrt (L ^ 2 * 2 * p.c / (p.m * (p.a - p.b)));
  for s = [0.999, 1.001]
    [~, sys] = at_speed (back, s * limit, {"x", "y", "yaw"});
    gsmbp_check (sprintf ("car, mass behind, at %.3f of its critical speed", s), ...
                 (max (real (eig (sys.a(2:3,2:3)))) > 0) == (s > 1));
  end
end

## forces and moment of the tyres in a turn, written anew
function e = turn (m)
  x = m.initial;
  x([4, 6]) = [20, 0.3];
  e = gsmbp_trim (m, x, [], "steady", {"x", "yaw"}, "free", {"delta", "thrust", "vy"});
  p = m.par;
  [vx, vy, om] = deal (num2cell (e.x(4:6)){:});
  total = [e.v(2) + p.m * vy * om; -p.m * vx * om; 0];
  for place = [p.a, p.a, -p.b, -p.b; p.w / 2, -p.w / 2, p.w / 2, -p.w / 2; e.v(1) * [1, 1, 0, 0]]
    [l, s, d] = deal (num2cell (place){:});
    F = p.c * (d - atan2 (vy + l * om, vx - s * om)) * [-sin(d); cos(d)];
    total += [F; l * F(2) - s * F(1)];
  end
  gsmbp_check ("car, in a turn: forces [N] and moment [N m]", total, 1e-8);
  gsmbp_check ("car, in a turn: the speed and rate that were given", e.x([4, 6]) - [20; 0.3], 0);
  gsmbp_check ("car, in a turn: the steering of the linear model", ...
               e.v(1) - 0.3 * (2.7 / 20 + 20 * p.m * 0.3 / (2.7 * 2 * p.c)), 2e-4);
  r = gsmbp_simulate (m, e.x, [0, 5], "input", e.v);
  gsmbp_check ("car, in a turn: it goes on so", r.x(end,4:6)' - e.x(4:6), 1e-8);
end

## another lane, 6 m beside, by steering of 0.1 rad at most; the same law with the mass behind,
## above the critical speed
function lane (m)
  e = at_speed (m, 20, "x");
  c = gsmbp_control (m, e, "lqg", "drop", "x", "measured", {"speed", "heading", "lane"}, ...
                     "Q", [0.1, 1, 1, 0.1, 1], "R", [100, 1e-6], "W", [0.1 1 1 1 1], "V", 1e-3, ...
                     "track", "lane", "period", 0.01, "delay", 0.02, "limits", [0.1; 4000], ...
                     "step_in", [0.01; 1e-3; 0.01]);
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, 0:0.05:8, "input", 6);
  gsmbp_check ("car, lane: there, and the speed is kept", ...
               [r.x(end,2) - 6, r.x(end,3), r.x(end,4) - 20], 0.05);
  gsmbp_check ("car, lane: the steering is at its limit, not above", ...
               max (abs (r.v(:,1))) - 0.1, 1e-12);
  x = e.x;
  x(4) = 60;
  back = gsmbp_set (mc, "a", m.par.b, "b", m.par.a);
  r = gsmbp_simulate (back, x, 0:0.05:8, "input", 6);
  gsmbp_check ("car, lane: mass behind, at 60 m/s, it does not come to its lane", ...
               max (abs (r.x(r.t > 6,2) - 6)) > 1 && max (abs (r.v(:,1))) >= 0.1);
end

## about the turn lane and heading run: speed and rate of turn are held
function round_and_round (m, e)
  said = warning ("off", "all");
  c = gsmbp_control (m, e, "lqg", "drop", "running", "measured", {"speed", "rate"}, "Q", ...
                     [1, 1, 100], "R", [100, 1e-6], "W", 1, "V", 1e-3, "integral", ...
                     {"speed", "rate"}, "Qi", [1, 100], "period", 0.01, "delay", 0.02, ...
                     "limits", [-0.1, 0.2; -4000, 4000]);
  warning (said);
  gsmbp_check ("car, in a turn: what is left", isequal (c.states(1:3)(:)', {"vx", "vy", "om"}));
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, [0, 1]);
  gsmbp_check ("car, in a turn: it starts without a bump", ...
               [r.x(end,4:6)' - e.x(4:6); r.v(1,1:2)' - e.v], 1e-9);
  heavy = gsmbp_set (mc, "m", 1800);
  r = gsmbp_simulate (heavy, e.x, [0, 15], "input", [18; 0.33]);
  gsmbp_check ("car, in a turn: heavier, to another speed and rate", ...
               r.x(end,[4, 6]) - [18, 0.33], 2e-3);
  file = [tempname() ".svg"];
  gsmbp_loop (c, file, mc, gsmbp_simulate (mc, e.x, 0:0.1:5, "input", [18; 0.33]));
  page = fileread (file);
  delete (file);
  gsmbp_check ("page of a loop: what is small beside the rest has its own axis", ...
               ! isempty (strfind (page, "rate, machine (right)")) ...
               && ! isempty (strfind (page, "delta, linear (right)")) ...
               && isempty (strfind (page, "speed, machine (right)")));
end
