## Whipple's bicycle: eigenvalues of straight running and M, C, K against Meijaard, Papadopoulos,
## Ruina, Schwab (2007); a steady turn goes on as it is found; a rider's controller holds it at a
## speed where it falls by itself, with samples, delay and limits, and where it fails.

function test_bicycle ()
  pkg load control
  m = gsmbp_fixture ("steady_bicycle");
  at = @(name) find (strcmp (m.states, name));
  drop = {"x", "y", "yaw", "rw", "fw"};
  x = m.initial;
  published = {0, [-5.530943717651390; -3.131643247906656; 3.131643247906656; 5.530943717651390]
               5, [-14.078389692798217; -0.775341882195845 - 4.464867713788229i; ...
                   -0.775341882195845 + 4.464867713788229i; -0.322866429004087]
               8, [-20.279408943945695; -2.693486835818097 - 8.460379713969931i; ...
                   -2.693486835818097 + 8.460379713969931i; 0.143278797657134]};
  for row = published'
    [v, wanted] = row{:};
    x(at ("rw_d")) = v / 0.3;
    if (v > 0)
      r = gsmbp_trim (m, x, [], "steady", "rw");
    else
      r.x = m.initial;
    end
    [sys, ~, k] = gsmbp_linear (m, 0, r.x, [], "drop", drop);
    found = pole (sys);
    [~, none] = min (abs (found));   # the speed may be another
    found(none) = [];
    away = arrayfun (@(s) min (abs (found - s)), wanted);
    gsmbp_check (sprintf ("bicycle, straight on at %g m/s: eigenvalues", v), away, 1e-8);
  end
  gsmbp_check ("bicycle: roll, steer and their rates, and its speed are left", ...
               isequal (m.states(k)', {"roll", "steer", "roll_d", "rw_d", "steer_d"}));
  x = r.x;
  x([at("rw_d"), at("yaw_d")]) = [5 / 0.3, 0.4];
  x([at("roll"), at("steer")]) = [-0.2, 0.08];
  said = gsmbp_complaint (@() gsmbp_trim (m, x, [], "steady", {"rw", "yaw"}));
  gsmbp_check ("bicycle, hands off: of speed and rate of turn one alone can be given", ...
               ! isempty (strfind (said, "no steady motion found")));
  r = gsmbp_trim (m, x, [], "steady", {"rw", "yaw"}, "free", "rw_d");
  gsmbp_check ("bicycle, in a turn: it leans inwards, about by v w/g", ...
               r.x(at ("roll")) + atan (0.3 * r.x(at ("rw_d")) * 0.4 / 9.81), 0.05);
  y = gsmbp_simulate (m, r.x, [0, 0.5]);
  kept = [at("roll"), at("steer"), at("yaw_d"), at("rw_d")];
  gsmbp_check ("bicycle, in a turn: it goes on so", y.x(end,kept) - r.x(kept)', 1e-7);
  [sys, ~, k] = gsmbp_linear (m, 0, r.x, [], "drop", drop);
  gsmbp_check ("bicycle, in a turn: constant coefficients", numel (k) == 5);
  canonical (m, drop);
  ridden (m, drop);
end

## M q'' + v C1 q' + (g K0 + v^2 K2) q, q = roll and steering; theirs is positive to the right
function canonical (m, drop)
  v = 4;
  x = m.initial;
  x(strcmp (m.states, "rw_d")) = v / 0.3;
  r = gsmbp_trim (m, x, [], "steady", "rw");
  k = gsmbp_mck (m, 0, r.x, r.v, "drop", drop);
  [~, at] = ismember ({"roll_d", "steer_d"}, k.speeds);
  [~, on] = ismember ({"roll", "steer"}, k.coordinates);
  T = diag ([1, -1]);
  M = [80.81722, 2.31941332208709; 2.31941332208709, 0.29784188199686];
  C1 = [0, 33.86641391492494; -0.85035641456978, 1.68540397397560];
  K0 = [-80.95, -2.59951685249872; -2.59951685249872, -0.80329488458618];
  K2 = [0, 76.59734589573222; 0, 2.65431523794604];
  gsmbp_check ("bicycle: M [kg m^2]", T * k.M(at,at) * T - M, 1e-11);
  gsmbp_check ("bicycle: C [N m s]", T * k.C(at,at) * T - v * C1, 1e-11);
  gsmbp_check ("bicycle: K [N m]", T * k.K(at,on) * T - 9.81 * K0 - v ^ 2 * K2, 1e-10);
end

## LQG from lean, bar and speed at 3 m/s, where it would fall: 100 Hz, 3 ms, 12 N m on the bar
function ridden (m, drop)
  at = @(name) find (strcmp (m.states, name));
  x = m.initial;
  x(at ("rw_d")) = 10;
  e = gsmbp_trim (m, x, [], "steady", "rw");
  sys = gsmbp_linear (m, 0, e.x, e.v, "drop", drop);
  gsmbp_check ("bicycle, at 3 m/s: it falls by itself", max (real (pole (sys))) > 1);
  c = gsmbp_control (m, e, "lqg", "drop", drop, "measured", {"lean", "bar", "speed"}, "Q", ...
                     [10, 1, 1, 1, 1], "R", 0.01, "W", 1, "V", 1e-4, "period", 0.01, "delay", ...
                     0.003, "limits", [12; 60], "step_in", [1e-3; 1e-3; 1e-2]);
  gsmbp_check ("bicycle, ridden: roll, steering and their rates, and its speed", ...
               isequal (c.states(1:5)(:)', m.states([at("roll"), at("steer"), at("roll_d"), ...
                                                     at("rw_d"), at("steer_d")])(:)'));
  mc = gsmbp_build (m.name, "directory", m.directory, "controller", c);
  r = gsmbp_simulate (mc, e.x, [0, 1]);
  gsmbp_check ("bicycle, ridden: straight on it goes on so", r.x(end,at ("roll")), 1e-3);
  for lean = [0.15, 0.6]
    x = e.x;
    x(at ("roll")) = lean;
    x = gsmbp_assemble (m, x, "hold", {"x", "y", "yaw", "roll", "rw", "fw", "steer"});
    fell = false;
    try
      r = gsmbp_simulate (mc, x, 0:0.05:4);
      fell = any (abs (r.x(end,[at("roll"), at("steer")])) > 0.05) || r.t(end) < 4;
    catch
      fell = true;
    end
    gsmbp_check (sprintf ("bicycle, ridden: from %.2g rad it %s", lean, {"holds", "falls"}{...
                          1 + (lean > 0.3)}), fell == (lean > 0.3));
  end
end
