## run.m: the benchmark, called by `make bench`. Writes report.md and report.json beside itself.
##
## For every system of systems/: derivation and compilation in seconds, operations of the emitted text (mul + add + div), time for one call, and
## the relative error of torques and accelerations (2-norm, worst of 200 random states) against the same Fortran in quad precision.
## Then the bench of the symbols. A yardstick, as many sines and cosines as the system has angles, tells what machine this was.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
systems = {"puma3", "puma6", "spat2", "spat3", "spat4", "spat5", "spat6", "spat8", "pend2", "pend4", "pend8", "pend16"};
if (! isempty (getenv ("BENCH_SYSTEMS")))
  systems = strsplit (getenv ("BENCH_SYSTEMS"));
end
out = fullfile (here, "out");
[~, ~] = mkdir (out);

function [rows, m] = measure (name, here, out)
  [cpu, wall] = gsmbp_derive (fullfile (here, "systems", [name ".mac"]), out);
  start = tic ();
  m = gsmbp_build (name, "directory", out);
  compile = toc (start);
  rand ("twister", 1);
  [torque, acceleration] = errors (m, gsmbp_build (name, "directory", out, "precision", "quad"));
  n = m.sizes.nq;
  s = gsmbp_timing (m, 0, [rand(n, 1); rand(n, 1)], "print", false);
  rows = struct ("system", name, "n", n, "derive_cpu", cpu, "compile", compile, "error_torque", torque, "error_acceleration", acceleration);
  for one = {"inv", "mas", "fwd", "lin"}
    k = strcmp ({m.json.subroutines.name}, upper ([name "_" one{1}]));
    c = m.json.subroutines(k).operations;
    rows.(one{1}) = struct ("operations", c.mul + c.add + c.div, "mul", c.mul, "add", c.add, "div", c.div, "trig", c.trig, "ns", 1e9 * s.(one{1}));
  end
end

function [torque, acceleration] = errors (m, exact)
  n = m.sizes.nq;
  torque = acceleration = 0;
  for k = 1:200
    q = 2 * pi * (rand (n, 1) - 0.5);
    u = 4 * (rand (n, 1) - 0.5);
    a = 10 * (rand (n, 1) - 0.5);
    reference = exact.inv (0, q, u, a);
    torque = max (torque, norm (m.inv (0, q, u, a) - reference) / norm (reference));
    reference = exact.fwd (0, q, u, [], a);
    acceleration = max (acceleration, norm (m.fwd (0, q, u, [], a) - reference) / norm (reference));
  end
end

## what one sine and one cosine cost here, in nanoseconds
function ns = yardstick ()
  x = linspace (-3, 3, 1e6);
  sin (x); cos (x);
  start = tic ();
  sin (x); cos (x);
  ns = 1e9 * toc (start) / numel (x);
end

function save_text (file, text)
  fid = fopen ([file ".new"], "w");
  fputs (fid, text);
  fclose (fid);
  rename ([file ".new"], file);
end

## the parts that all modules share are compiled once, ahead of the measurements
gsmbp_derive (fullfile (here, "systems", "pend2.mac"), out);
gsmbp_build ("pend2", "directory", out);
gsmbp_build ("pend2", "directory", out, "precision", "quad");

results = cell (1, numel (systems));
for k = 1:numel (systems)
  printf ("%s ...\n", systems{k});
  results{k} = measure (systems{k}, here, out);
end
table = fullfile (out, "symbols.md");
if (system (sprintf ("'%s' '%s'", fullfile (here, "symbols"), table)) != 0)
  error ("bench: tests/bench/symbols failed");
end

text = sprintf (["# Benchmark\n\nWritten by `make bench`: compare ratios, not times of other machines. One sine and one cosine, in a vector: %.1f ns.\n\n" ...
  "Operations are mul + add + div of the executed Fortran, parameters literal; sines and cosines apart. Seconds of derivation are of processor time, Maxima's\n" ...
  "start and everything that the scene can have included. Errors: relative, 2-norm, worst of 200 random states against quad precision.\n\n" ...
  "| system | derive s | compile s | inverse | ns | mass | ns | forward | ns | linear | ns | error torque | error acceleration |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n"], yardstick ());
for r = [results{:}]
  text = [text, sprintf("| %s | %.2f | %.2f | %d | %.0f | %d | %.0f | %d | %.0f | %d | %.0f | %.1e | %.1e |\n", r.system, r.derive_cpu, r.compile, r.inv.operations, r.inv.ns, ...
    r.mas.operations, r.mas.ns, r.fwd.operations, r.fwd.ns, r.lin.operations, r.lin.ns, r.error_torque, r.error_acceleration)];
end
text = [text, "\n## Derivation of the examples\n\nProcessor seconds, best of three, Maxima's start included; the aim is below 3.\n\n| example | derive s |\n|---|---|\n"];
for name = {"puma560", "slider_crank"}
  cpu = min (arrayfun (@(k) gsmbp_derive (fullfile (root, "examples", name{1}, [name{1} ".mac"])), 1:3));
  text = [text, sprintf("| %s | %.2f |\n", name{1}, cpu)];
end
save_text (fullfile (here, "report.md"), [text, "\n", regexprep(fileread (table), "^#", "##", "lineanchors")]);
save_text (fullfile (here, "report.json"), jsonencode ([results{:}]));
puts (text);
