## Whipple's bicycle: eigenvalues of straight running against Meijaard, Papadopoulos, Ruina, Schwab
## (2007), table 2; a steady turn goes on as it is found; M, C and K have their canonical form.

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
end
