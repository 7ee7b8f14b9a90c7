## c = bench_cases (): the mechanisms of the bench, a struct array.
##
## Fields: name (examples/NAME/NAME.mac or systems/NAME.mac); times of the comparison; hold: coordinates that keep their start value while the loops
## are closed; speeds: what names of speeds begin with, and their start; options of gsmbp_simulate; what: a few words. A mechanism whose scene is not there is left out.

function c = bench_cases ()
  c = struct ([]);
  c = add (c, "slider_crank", 0:0.5:2, {"q1"}, {}, {"input", 6}, "motor at 6 V from rest, gravity across the slide");
  c = add (c, "four_bar", 0:0.5:2, {}, {}, {}, "crank-rocker let go under gravity");
  c = add (c, "andrews", 0:0.005:0.03, {}, {}, {}, "seven plane links, three loops, stiff spring, crank up to 1100 rad/s");
  c = add (c, "bricard", 0:1:4, {}, {}, {}, "spatial six-bar let go under gravity, redundant in every position");
  c = add (c, "stewart", 0:0.25:1, {}, {"x_d", 0.3, "wx", 1, "wz", 1.5}, {}, "platform on six legs UPS, swinging on its gas springs, Euler parameters");
  c = add (c, "hooke", 0:0.5:2, {}, {}, {"input", 24}, "universal joint between two shafts, motor at 24 V from rest");
  c = add (c, "lead_screw", 0:0.5:2, {}, {}, {"input", 24}, "helical joint lifts a table, motor at 24 V from rest");
  c = add (c, "rolling_disc", 0:0.5:2, {}, {"w1", 0.5, "w2", 10, "w3", 1}, {}, "coin that rolls without slip, Euler parameters");
  c = add (c, "ladder5", 0:0.5:3, {}, {"q", -1, "p", 1}, {}, "five four-bars in a ladder, through three singular positions");
end

function c = add (c, name, times, hold, speeds, options, what)
  c = [c, struct("name", name, "times", times, "hold", {hold}, "speeds", {speeds}, "options", {options}, "what", what)];
end
