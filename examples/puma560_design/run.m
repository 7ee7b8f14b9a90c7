## The first three axes of a PUMA 560 designed: from the paper's motion with a load and the way back
## without it, an accuracy, a supply and a catalogue through motors, gears, controllers and gains
## to a machine that was run at the corners of its tolerances. The page design.html, its figures and
## the report go into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

pkg load control   # before gsmbp_build: Octave calls a module slowly once its load path has changed

m = derived_model ("puma560_design");
puts ("\n");

## ---------------------------------------------------------------- what is asked
q0 = [0.5; -0.75; 0.5];
there = gsmbp_plan ("quintic", [q0, zeros(3, 1)], [0 1]);
back = gsmbp_plan ("quintic", [zeros(3, 1), q0], [0 1]);
s.motion = {"loaded", there, struct(); "back, empty", back, struct("ml", 0)};
s.accuracy = 1e-3;                     # rad
[s.supply, s.current] = deal (48, 30); # V, A
s.goal = "mass";
s.inertia_ratio = 10;
[s.period, s.delay] = deal (1e-3, 5e-4);
s.encoder = 1e-5;
s.tolerances = {"ml", 0.2; "m2", 0.05; "motor2_K", 0.05};
s.file = "out/design.html";
r = gsmbp_design (m, s);

tell_design (r);
for k = 1:3
  gsmbp_drive_plot (sprintf ("out/plane%d.png", k), r.drives(k), "plane", r.best{k}.name);
endfor
gsmbp_loop (r.controller, "out/loop.png", r.machine, r.runs{1});
tracked_figure ("out/tracking.png", r, 1);
diary off
