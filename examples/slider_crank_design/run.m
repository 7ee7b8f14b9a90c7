## The slider-crank of Ju and Hsu (1991) designed: from the paper's motion, an accuracy, a supply
## and a catalogue through a spring, a motor and a gear, a controller and its gains to a machine
## that was run at the corners of its tolerances. The page design.html, its figures and the report
## go into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

pkg load control   # before gsmbp_build: Octave calls a module slowly once its load path has changed

m = derived_model ("slider_crank_design");
puts ("\n");

## ---------------------------------------------------------------- what is asked
## the crank's acceleration as in the paper: up linearly to 4 rad/s^2 in 1 s, down to zero at 2 s,
## then constant speed
s.motion = gsmbp_plan ("profile", mkpp ([0 1 2 6], [4 0; -4 4; 0 0]), 2);
s.accuracy = 2e-3;                     # rad
[s.supply, s.current] = deal (48, 15); # V, A
s.goal = "energy";
s.inertia_ratio = 10;
[s.period, s.delay] = deal (1e-3, 5e-4);
s.encoder = 2 * pi / 20000;
s.springs = {"k", [0 2000]};
s.tolerances = {"m2", 0.05; "m3", 0.1; "motor_R", 0.1; "motor_K", 0.05; "gear_Tc", 0.5};
s.file = "out/design.html";
r = gsmbp_design (m, s);

tell_design (r);
gsmbp_drive_plot ("out/plane.png", r.drives, "plane", r.best{1}.name);
gsmbp_loop (r.controller, "out/loop.png", r.machine, r.runs{1});
tracked_figure ("out/tracking.png", r, 1);
diary off
