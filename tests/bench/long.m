## long.m: the bench of long free runs, called by `make bench-long`. Writes long.md beside itself.
##
## The unforced four-bar of the examples, 1e7 steps of 1 ms by collocation of Gauss of order 6, as
## it swings to and fro from rest and as its crank goes round: the energy at 4000 times in each
## tenth of the run, what the loop misses, memory. STEPS: another number of steps.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
out = fullfile (here, "out", "long");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:singular");

## the process, MB
function size = memory_used ()
  pages = sscanf (fileread ("/proc/self/statm"), "%d");
  size = pages(2) * 4096 / 2^20;
end

## share of the energy that was gained or lost at each row
function off = energy (m, r)
  E = arrayfun (@(k) sum (m.ene (r.t(k), r.x(k,:)')(1:2)), 1:numel (r.t));
  off = (E - E(1)) / abs (E(1));
end

steps = str2double (getenv ("STEPS"));
if (isnan (steps))
  steps = 1e7;
end
h = 1e-3;
gsmbp_derive (fullfile (root, "examples", "four_bar", "four_bar.mac"), out);
m = gsmbp_build ("four_bar", "directory", out);
text = ["| four-bar | steps | tenth | energy at most | in the mean | at its last row |\n" ...
        "|---|---|---|---|---|---|\n"];
told = "";
## rows in every tenth, whole steps apart, that meet every place of a turn
tenth = steps / 10;
apart = floor (min (tenth, 1e5) / 4000);
t = h * [0, reshape((0:9) * tenth + (1:4000)' * apart, 1, []), steps + apart];
for one = {"to and fro", 0; "round and round", 10}'
  start = gsmbp_assemble (m, [1 -0.1 1.4 one{2} 0 0], "hold", "theta");
  gsmbp_simulate (m, start, t / 100, "method", "gauss", "step", h);   # as many rows
  before = memory_used ();
  r = gsmbp_simulate (m, start, t, "method", "gauss", "step", h);
  after = memory_used ();
  off = energy (m, r);
  for k = 1:10
    rows = off((k-1) * 4000 + (2:4001));
    text = [text, sprintf("| %s | %d | %d | %.1e | %.1e | %.1e |\n", one{1}, ...
                          r.stats.accepted, k, max (abs (rows)), mean (rows), rows(end))];
  end
  told = [told, sprintf(["\n%s: theta at the end %.6g rad, energy there %.1e, the loop off by " ...
                         "at most %.1e m, %.1e m/s; %.1f us a step; memory %.1f MB before, " ...
                         "%.1f behind\n"], one{1}, r.x(end,1), off(end), r.stats.drift.phi, ...
                        r.stats.drift.phidot, 1e6 * r.stats.seconds / r.stats.accepted, before, ...
                        after)];
end
text = ["# Long free runs\n\n" text told];
f = fopen (fullfile (here, "long.md"), "w");
fputs (f, text);
fclose (f);
puts (text);
