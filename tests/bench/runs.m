## runs.m: the bench of single runs, called by `make bench-runs`. Writes runs.md beside itself.
##
## What output times cost dp853: calls of the right-hand side for 1 s with two rows and with 1001,
## the largest error of the rows beside a run at rtol = 1e-13 and the largest of each state. What
## long runs by the method gauss do to the energy: a double pendulum that swings, a four-bar whose
## crank turns on.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"), fullfile (root, "octave", "hand"));
out = fullfile (here, "out", "runs");
[~, ~] = mkdir (out);
for id = {"stiff", "tolerance", "singular"}
  warning ("off", ["gsmbp:" id{1}]);
end

function m = scene_of (out, file)
  gsmbp_derive (file, out);
  [~, name] = fileparts (file);
  m = gsmbp_build (name, "directory", out);
end

function text = rows_of (m, x0, options)
  text = "";
  t = linspace (0, 1, 1001);
  exact = gsmbp_simulate (m, x0, t, options{:}, "rtol", 1e-13).x;
  for rtol = [1e-6, 1e-8, 1e-10]
    two = gsmbp_simulate (m, x0, [0 1], options{:}, "rtol", rtol);
    many = gsmbp_simulate (m, x0, t, options{:}, "rtol", rtol);
    e = max (max (abs (many.x - exact)) ./ (max (abs (exact)) + m.nominal'));
    text = [text, sprintf("| %s | %g | %d | %d | %.1e |\n", m.name, rtol, two.stats.calls, ...
                          many.stats.calls, e)];
  end
end

## the largest share of the energy that was gained or lost, and how it stands at the end
function [most, last] = energy (m, r)
  E = arrayfun (@(k) sum (m.ene (r.t(k), r.x(k,:)')(1:2)), 1:numel (r.t));
  off = (E - E(1)) / max (abs (E(1)), eps);
  [most, last] = deal (max (abs (off)), off(end));
end

text = ["# Single runs\n\n| scene | rtol | calls, 2 rows | calls, 1001 rows " ...
        "| error of the rows |\n|---|---|---|---|---|\n"];
scenes = fullfile (root, "tests", "scenes");
crank = scene_of (out, fullfile (scenes, "sensitivity_crank.mac"));
arms = scene_of (out, fullfile (scenes, "gauss_arms.mac"));
bars = scene_of (out, fullfile (root, "examples", "four_bar", "four_bar.mac"));
text = [text, rows_of(gsmbp_hand ("motor_pendulum"), [0.2; 0; 0], {"input", 3}), ...
        rows_of(crank, gsmbp_assemble (crank, [0.3 -0.1 0.7 2 0 0 0.5], "hold", "q1"), ...
                {"input", 12}), rows_of(arms, [1; 0.5; 0; 0], {})];

text = [text, "\n| long run | method | steps | largest share of the energy | at the end |\n" ...
        "|---|---|---|---|---|\n"];
cases = {"gauss_arms", arms, [-1; 0.3; 0; 0], 0:10:1000, {"method", "gauss", "step", 2.5e-3}; ...
         "gauss_arms", arms, [-1; 0.3; 0; 0], 0:10:1000, {"rtol", 1e-8}};
start = gsmbp_assemble (bars, [1 -0.1 1.4 10 0 0], "hold", "theta");
for h = [1e-3, 5e-4]
  cases = [cases; {"four_bar", bars, start, 0:2:40, {"method", "gauss", "step", h}}];
end
for one = cases'
  r = gsmbp_simulate (one{2:4}, one{5}{:});
  [most, last] = energy (one{2}, r);
  said = sprintf ("%s %g", one{5}{end-1:end});
  text = [text, sprintf("| %s, %g s | %s, %s | %d | %.1e | %.1e |\n", one{1}, r.t(end), ...
                        r.stats.method, said, r.stats.accepted, most, last)];
end
f = fopen (fullfile (here, "runs.md"), "w");
fputs (f, text);
fclose (f);
puts (text);
