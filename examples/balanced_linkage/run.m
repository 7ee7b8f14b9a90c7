## Balanced linkage: the weights behind crank and rocker of a four-bar, chosen by gsmbp_optimize: at
## rest, along a motion, within a mass, from a box of weights; what is asked too much. Everything
## goes into out/.

source (fullfile (fileparts (mfilename ("fullpath")), "..", "common", "begin.m"));

## a line of the table: weights, arms, mass of the weights, effort along the motion
function line (name, r, plan, t)
  p = r.model.par;
  tau = gsmbp_inverse (r.model, plan, t).tau;
  printf ("%-34s %8.4f %8.4f %8.4f %8.4f %10.4f %10.4f %10.4f\n", name, p.w1, p.r1, p.w3, p.r3, ...
          p.w1 + p.w3, sqrt (mean (tau .^ 2)), max (abs (tau)));
endfunction

## ---------------------------------------------------------------- the model
m = derived_model ("balanced_linkage");
puts ("\n");
range_ = {"w1", 1, [0 20]; "r1", 0.05, [0.01 0.08]; "w3", 1, [0 20]; "r3", 0.1, [0.01 0.3]};
round_ = {"positions", "q1", (0.6:1:6)'};
t = (0:0.05:1)';
plan = gsmbp_plan ("quintic", [0.6 2.6], [0 1]);
go = {"inverse", plan, t, "name", "go"};

## ------------------------------------------- at rest, along a motion, within a mass
printf ("%-34s %8s %8s %8s %8s %10s %10s %10s\n", "weights", "w1 [kg]", "r1 [m]", "w3 [kg]", ...
        "r3 [m]", "both [kg]", "rms [N m]", "peak [N m]");
none.model = gsmbp_set (m, "w1", 0, "w3", 0);
line ("none", none, plan, t);
rest = gsmbp_optimize (m, range_, {"mass", "front, back"}, {"each", "effort.q1", "=", 0}, round_);
line ("lightest that balance at rest", rest, plan, t);
moving = gsmbp_optimize (m, range_, {"rms", "effort.q1"}, {}, go);
line ("least rms effort along the motion", moving, plan, t);
heavy = {"mass", "front, back", "<", 3};
light = gsmbp_optimize (m, range_, {"rms", "effort.q1"}, heavy, go);
line ("the same with 3 kg", light, plan, t);
peak = gsmbp_optimize (m, range_, {"peak", "effort.q1"}, heavy, go, "starts", 2);
line ("least peak with 3 kg", peak, plan, t);

p = m.par;
known = [(p.m1 * p.a / 2 + p.m2 / 2 * p.a) / 0.08, (p.m3 * p.c / 2 + p.m2 / 2 * p.c) / 0.3];
printf ("\nbalance at rest beside the closed form of Berkof and Lowen: %.1e\n", ...
        max (abs ([rest.values.w1, rest.values.w3] ./ known - 1)));
price = light.active(strncmp ({light.active.text}, "mass", 4)).multiplier;
more = gsmbp_optimize (m, range_, {"rms", "effort.q1"}, {"mass", "front, back", "<", 3.01}, go);
printf (["one more kilogram is worth %.5f N m (multiplier), by an optimum with 10 g more " ...
         "%.5f N m\n\n"], price, (light.J - more.J) / 0.01);
puts (light.report);

## ------------------------------------------------------------- from a box of weights
## 0.25 kg steps, holes every 10 mm
weights = num2cell (0:0.25:5);
free = {"w1", 1, weights; "r1", 0.05, num2cell(0.01:0.01:0.08)
        "w3", 1, weights; "r3", 0.1, num2cell(0.01:0.01:0.3)};
fast = {"inverse", plan, t(1:2:end), "name", "go"};
box = gsmbp_optimize (m, free, {"rms", "effort.q1"}, heavy, fast);
printf ("\n");
line ("from the box, with 3 kg", box, plan, t);
printf ("%d problems solved for %d combinations\n\n", box.choices.solved, ...
        box.choices.combinations);

## ------------------------------------------------------------------ what is too much
demands = [heavy; {"peak", "effort.q1", "<", 0.3; "value", "r3", "<", 0.25}];
[r, info] = gsmbp_optimize (m, range_, {"mass", "front, back"}, demands, fast);
printf ("asked too much (%d): %s\n", info, r.ended);
diary off

## ------------------------------------------------------------------------- figures
tau = cell2mat (cellfun (@(r) gsmbp_inverse (r.model, plan, t).tau, {none, rest, moving, light}, ...
                         "UniformOutput", false));
names = {"none", "balanced at rest", "least along the motion", "the same with 3 kg"};
gsmbp_plot ("out/figure_effort.png", t, panel (tau, names, "effort of the crank [N m]"), ...
            "title", "Four-bar: what the motor has to give");
