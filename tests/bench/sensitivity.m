## sensitivity.m: the bench of derivatives by parameters, called by `make bench-sensitivity`. Writes
## sensitivity.md beside itself.
##
## Slider-crank with motor, four-bar, PUMA with motors, ten parameters each: the run with their
## columns beside the run alone and beside central differences (20 runs, as they stand and at the
## tolerance that they need for their best error); a chain of eight links with 40 parameters: the
## adjoint beside the run alone. Times alternate, the least of many counts. Errors: beside columns
## at rtol = 1e-13.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
out = fullfile (here, "out", "sensitivity");
[~, ~] = mkdir (out);

## the scene of a file with requests of its own
function m = scene_of (out, name, text, names)
  file = fullfile (out, [name ".mac"]);
  f = fopen (file, "w");
  fprintf (f, "%s\nrequests : '[all, adjoint, sensitivity(%s)]$\n", text, strjoin (names, ", "));
  fclose (f);
  gsmbp_derive (file, out);
  m = gsmbp_build (name, "directory", out);
end

function text = example_of (root, name)
  text = sprintf ("load(\"%s\")$", fullfile (root, "examples", name, [name ".mac"]));
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

function e = worst (found, exact, names)
  e = max (cellfun (@(p) norm (found.(p) - exact.(p), Inf) / norm (exact.(p), Inf), names));
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
function row = machine (m, names, x0, T, v)
  x = x0 (m);
  go = @(rtol) gsmbp_simulate (m, x, [0 T], "input", v, "rtol", rtol, "sensitivity", names);
  take = @(r) structfun (@(a) a(end,:), r.dx, "UniformOutput", false);
  alone = @() gsmbp_simulate (m, x, [0 T], "input", v).stats.seconds;
  t = alternate ({alone, @() go(1e-10).stats.seconds});
  exact = take (go (1e-13));
  own = worst (take (go (1e-10)), exact, names);
  best = Inf;
  for rtol = [1e-10, 1e-13]
    for h = [1e-4, 1e-5, 1e-6]
      [D, seconds] = differences (@(m) at_end (m, x0, T, v, rtol), m, names, h);
      if (worst (D, exact, names) < best)
        [best, time, at] = deal (worst (D, exact, names), seconds, rtol);
      end
    end
  end
  row = sprintf ("| %s | %.3g ms | %.3g ms | %.2f | %.1e | %.3g ms, rtol %g | %.1e | %.3f |\n", ...
                 m.name, 1e3 * t(1), 1e3 * t(2), t(2) / t(1), own, 1e3 * time, at, best, ...
                 t(2) / time);
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

text = ["# Derivatives by parameters\n\n| scene | run | with 10 columns | ratio | error | " ...
        "central differences | their error | ratio |\n|---|---|---|---|---|---|---|---|\n"];
names = {"g", "l1", "l2", "m1", "m2", "m3", "n", "ra", "la", "km"};
m = scene_of (out, "slider_crank", example_of (root, "slider_crank"), names);
text = [text, machine(m, names, @(m) gsmbp_assemble (m, [0.3 -0.1 0.7 2 0 0 0.5], "hold", "q1"), ...
                      0.5, 12)];
names = {"g", "la", "lb", "lc", "ld", "mu", "mp"};
m = scene_of (out, "four_bar", example_of (root, "four_bar"), names);
text = [text, machine(m, names, @(m) gsmbp_assemble (m, [1 -0.1 1.4 3 0 0], "hold", "theta"), ...
                      0.5, 0.3)];
names = {"g", "a2", "d3", "m2", "m3", "jy1", "n1", "jm", "ra", "la"};
m = scene_of (out, "puma560", example_of (root, "puma560"), names);
text = [text, machine(m, names, @(m) [0.1 0.2 -0.3 0.1 0.2 0.3 0.5 -0.2 0.1]', 0.05, [5 -10 3])];

[scene, names] = chain (8);
m = scene_of (out, "chain8", scene, names);
x = [0.3 * ones(8, 1); zeros(8, 1)];
goal = @(r) deal (r.x(end,1), [zeros(1, 16); eye(1, 16)]);
t = alternate ({@() gsmbp_simulate(m, x, [0 1]).stats.seconds, ...
                @() sum(gsmbp_adjoint (m, x, [0 1], goal).seconds)});
a = gsmbp_adjoint (m, x, [0 1], goal);
r = gsmbp_simulate (m, x, [0 1], "rtol", 1e-13, "sensitivity", names);
e = max (cellfun (@(p) abs (a.dJ.(p) - r.dx.(p)(end,1)), names)) ...
    / max (cellfun (@(p) abs (r.dx.(p)(end,1)), names));
text = [text, sprintf(["\nchain8, 40 parameters, one goal: run %.3g ms, adjoint (forward and " ...
                       "back) %.3g ms, ratio %.2f, error %.1e\n"], 1e3 * t, t(2) / t(1), e)];
f = fopen (fullfile (here, "sensitivity.md"), "w");
fputs (f, text);
fclose (f);
puts (text);
