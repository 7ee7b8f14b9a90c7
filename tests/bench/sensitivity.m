## sensitivity.m: the bench of derivatives by parameters, called by `make bench-sensitivity`. Writes
## sensitivity.md beside itself.
##
## Slider-crank with motor, four-bar, PUMA with motors, ten parameters each: the run with their
## columns beside the run alone and beside central differences (20 runs, as they stand and at the
## tolerance that they need for their best error); motions that bounce, stick and slide; a chain of
## eight links with 40 parameters: the adjoint beside the run alone. Times alternate, the least of
## many counts. Errors: beside the same run in quad precision at rtol = 1e-18, of one with another
## (times the parameter, beside the largest).

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
out = fullfile (here, "out", "sensitivity");
[~, ~] = mkdir (out);

## the scene of a file with requests of its own
## and its build in quad precision
function [m, q] = scene_of (out, name, text, names, words = "adjoint, ")
  file = fullfile (out, [name ".mac"]);
  f = fopen (file, "w");
  fprintf (f, "%s\nrequests : '[all, %ssensitivity(%s)]$\n", text, words, ...
           strjoin (names, ", "));
  fclose (f);
  gsmbp_derive (file, out);
  m = gsmbp_build (name, "directory", out);
  q = gsmbp_build (name, "directory", out, "precision", "quad");
end

function text = example_of (root, name)
  text = sprintf ("load(\"%s\")$", fullfile (root, "examples", name, [name ".mac"]));
end

## the four-bar with a spring and a damper at the rocker and a rotor on the crank
function text = loaded_four_bar (root)
  text = fileread (fullfile (root, "examples", "four_bar", "four_bar.mac"));
  text = strrep (text, "inertia = [0, mu*la^3/12, mu*la^3/12]", ...
                 "inertia = [0, mu*la^3/12, mu*la^3/12 + jr]");
  text = strrep (text, "drive(motor, joint = A),", ["drive(motor, joint = A), " ...
                 "spring(sp, stiffness = k, joint = D), damper(da, damping = c, joint = D),"]);
  text = strrep (text, "mp = 0.2*kg]", ["mp = 0.2*kg, k = 1*N*m/rad, c = 0.05*N*m*s/rad, " ...
                 "jr = 1e-3*kg*m^2]"]);
end

## least times of calls that alternate
function least = alternate (calls)
  least = Inf (1, numel (calls));
  started = tic ();
  while (toc (started) < 8)
    for k = 1:numel (calls)
      least(k) = min (least(k), calls{k}());
    end
  end
end

function e = worst (m, found, exact, names)
  by = @(of) cellfun (@(p) m.par.(p) * norm (of(p), Inf), names);
  e = max (by (@(p) found.(p) - exact.(p))) / max (by (@(p) exact.(p)));
end

## central differences of the end, relative steps H
function [D, seconds] = differences (run, m, names, h)
  seconds = 0;
  for p = names
    [above, s1] = run (gsmbp_set (m, p{1}, m.par.(p{1}) * (1 + h)));
    [below, s2] = run (gsmbp_set (m, p{1}, m.par.(p{1}) * (1 - h)));
    D.(p{1}) = (above - below) / (2 * h * m.par.(p{1}));
    seconds += s1 + s2;
  end
end

function [x, seconds] = at_end (m, x0, T, v, rtol)
  r = gsmbp_simulate (m, x0 (m), [0 T], "input", v, "rtol", rtol);
  x = r.x(end,:);
  seconds = r.stats.seconds;
end

## a row of the table
function row = machine (m, q, names, x0, T, v)
  x = x0 (m);
  go = @(m, rtol) gsmbp_simulate (m, x, [0 T], "input", v, "rtol", rtol, "sensitivity", names);
  take = @(r) structfun (@(a) a(end,:), r.dx, "UniformOutput", false);
  alone = @() gsmbp_simulate (m, x, [0 T], "input", v).stats.seconds;
  t = alternate ({alone, @() go(m, 1e-10).stats.seconds});
  exact = take (go (q, 1e-18));
  own = arrayfun (@(rtol) worst (m, take (go (m, rtol)), exact, names), [1e-10, 1e-12]);
  best = Inf;
  for rtol = [1e-10, 1e-13]
    for h = [1e-4, 1e-5, 1e-6]
      [D, seconds] = differences (@(m) at_end (m, x0, T, v, rtol), m, names, h);
      if (worst (m, D, exact, names) < best)
        [best, time, at] = deal (worst (m, D, exact, names), seconds, rtol);
      end
    end
  end
  row = sprintf (["| %s | %.3g ms | %.3g ms | %.2f | %.1e, %.1e | %.3g ms, rtol %g | %.1e " ...
                  "| %.3f |\n"], m.name, 1e3 * t(1), 1e3 * t(2), t(2) / t(1), own, ...
                 1e3 * time, at, best, t(2) / time);
end

## a motion with events
function row = jumping (m, q, names, x0, T, options)
  go = @(m, rtol) gsmbp_simulate (m, x0, [0 T], "rtol", rtol, "sensitivity", names, options{:});
  r = go (m, 1e-10);
  take = @(r) structfun (@(a) a(end,:), r.dx, "UniformOutput", false);
  exact = take (go (q, 1e-18));
  e = arrayfun (@(rtol) worst (m, take (go (m, rtol)), exact, names), [1e-10, 1e-12]);
  row = sprintf ("| %s | %d | %.1e | %.1e |\n", m.name, numel (r.events.t), e);
end

## a chain of N links with five parameters each
function [text, names] = chain (n)
  names = {};
  parts = {};
  parameters = {"g = 9.81*m/s^2"};
  for k = 1:n
    before = {"ground", sprintf("b%d", k - 1)}{1 + (k > 1)};
    at = {"", sprintf(", at = [l%d, 0, 0]", k - 1)}{1 + (k > 1)};
    parts{end+1} = strrep (["link(b#, mass = m#, centre = [l#/2, 0, 0], inertia = [0, 0, J#]), " ...
                            "revolute(r#, " before ", b#" at ", axis = z, coordinate = q#, " ...
                            "friction = d#), spring(s#, stiffness = k#, joint = r#)"], "#", ...
                           sprintf ("%d", k));
    parameters{end+1} = sprintf (["m%d = 1*kg, l%d = 0.3*m, J%d = 0.01*kg*m^2, " ...
                                  "d%d = 0.05*N*m*s/rad, k%d = 2*N*m/rad"], k, k, k, k, k);
    names = [names, arrayfun(@(c) sprintf ("%s%d", c, k), "mlJdk", "UniformOutput", false)];
  end
  text = sprintf (["scene : gsmbp_scene(\"chain%d\", gravity = [0, -g, 0], %s, " ...
                   "parameters = [%s])$"], n, strjoin (parts, ",\n  "), ...
                  strjoin (parameters, ",\n  "));
end

text = ["# Derivatives by parameters\n\n| scene | run | with 10 columns | ratio " ...
        "| error, rtol 1e-10, 1e-12 | " ...
        "central differences | their error | ratio |\n|---|---|---|---|---|---|---|---|\n"];
names = {"g", "l1", "l2", "m1", "m2", "m3", "n", "ra", "la", "km"};
[m, q] = scene_of (out, "slider_crank", example_of (root, "slider_crank"), names);
start = @(m) gsmbp_assemble (m, [0.3 -0.1 0.7 2 0 0 0.5], "hold", "q1");
text = [text, machine(m, q, names, start, 0.5, 12)];
names = {"g", "la", "lb", "lc", "ld", "mu", "mp", "k", "c", "jr"};
[m, q] = scene_of (out, "four_bar", loaded_four_bar (root), names);
text = [text, machine(m, q, names, @(m) gsmbp_assemble (m, [1 -0.1 1.4 3 0 0], "hold", "theta"), ...
                      0.5, 0.3)];
names = {"g", "a2", "d3", "m2", "m3", "jy1", "n1", "jm", "ra", "la"};
[m, q] = scene_of (out, "puma560", example_of (root, "puma560"), names);
text = [text, machine(m, q, names, @(m) [0.1 0.2 -0.3 0.1 0.2 0.3 0.5 -0.2 0.1]', 0.05, [5 -10 3])];

text = [text, "\n| motion with events | events | error at rtol 1e-10 | at 1e-12 |\n" ...
        "|---|---|---|---|\n"];
cases = {"ball", {"g", "lo", "e"}, [1 0 0.3 0], 2.4, {}; ...
         "belt", {"m", "k", "fc", "vb"}, [0; 0.05; 0.5; 0.4], 1.5, ...
         {"fixed", "s", "dx0", [0 0 0 0; 0 0 0 0; 0 0 0 1; 0 0 0 -1]}; ...
         "arm", {"m1", "l", "hi", "e", "f1", "f2"}, [1.5; 0.3; 0; 5], 2, ...
         {"input", mkpp([0 3], [0.4 -0.5])}};
for one = cases'
  name = ["sensitivity_" one{1}];
  [m, q] = scene_of (out, name, fileread (fullfile (root, "tests", "scenes", [name ".mac"])), ...
                     one{2}, "");
  text = [text, jumping(m, q, one{2:end})];
end

[scene, names] = chain (8);
[m, q] = scene_of (out, "chain8", scene, names);
x = [0.3 * ones(8, 1); zeros(8, 1)];
goal = @(r) deal (r.x(end,1), [zeros(1, 16); eye(1, 16)]);
t = alternate ({@() gsmbp_simulate(m, x, [0 1]).stats.seconds, ...
                @() sum(gsmbp_adjoint (m, x, [0 1], goal).seconds)});
a = gsmbp_adjoint (m, x, [0 1], goal);
r = gsmbp_simulate (q, x, [0 1], "rtol", 1e-18, "sensitivity", names);
e = max (cellfun (@(p) abs (a.dJ.(p) - r.dx.(p)(end,1)), names)) ...
    / max (cellfun (@(p) abs (r.dx.(p)(end,1)), names));
text = [text, sprintf(["\nchain8, 40 parameters, one goal: run %.3g ms, adjoint (forward and " ...
                       "back) %.3g ms, ratio %.2f, error %.1e\n"], 1e3 * t, t(2) / t(1), e)];
f = fopen (fullfile (here, "sensitivity.md"), "w");
fputs (f, text);
fclose (f);
puts (text);
