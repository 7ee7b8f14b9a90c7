## peers.m: whole runs beside those of others, called by `make bench-peers` and `make bench
## PEERS=1`. Writes peers.md beside itself, figures into out/peers_runs.
##
## The PUMA's six links and six general links falling freely, a slider-crank turning freely: time
## against the largest error of a coordinate at the end, of GSMBP, of CasADi's C code in the same
## integrator, of SciPy, MuJoCo and Drake, each by all its methods at many steps or tolerances, in
## one process after the other, in turns, the least time of all counts. The truth is the emitted
## Fortran in quad precision, and beside it other equations with another integrator in 25 digits
## (truth.py). At every error it is told where another one is faster. BENCH_SYSTEMS="puma6 spat6":
## these only; TURNS=1: how often, 3 otherwise; a peer that PyPI does not have here is told and left
## out.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"), fullfile (here, "peers"));
out = fullfile (here, "out", "peers_runs");
peers = fullfile (here, "out", "peers");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:stiff");
warning ("off", "gsmbp:tolerance");

start = {[0.3, -0.5, 0.4, 0.2, 0.6, -0.3], [0.5, -0.2, 0.3, 0.1, -0.4, 0.2]};
systems = [{"puma6", 1}, start; {"spat6", 1}, start; {"slidercrank", 1, 0.5, 10}]';
wanted = strsplit (getenv ("BENCH_SYSTEMS"), " ");
text = ["# Whole runs beside those of others\n\nMade by `make bench-peers`; see " ...
        "tests/bench/peers.m. Microseconds of GSMBP for a run of 1 s within an error, then how " ...
        "many times as long others take; - was not reached.\n"];
misses = {};
for row = systems
  if (! (isempty ([wanted{:}]) || any (strcmp (row{1}, wanted))))
    continue;
  end
  s = peers_scene (row', out);
  [w, notes] = peers_measured (s, peers);
  save ("-binary", fullfile (s.folder, "measured.bin"), "w", "notes");
  [more, of_it] = peers_table (s, w, notes);
  if (s.m.sizes.nlam == 0)
    more = [more, peers_rollout(s, peers)];
  end
  peers_figure (fullfile (out, [s.name ".png"]), s, w);
  text = [text, more];
  misses = [misses, of_it];
  puts (more);
  fflush (stdout);
end
last = {sprintf("\nNot left of: %s.\n", strjoin (misses, "; ")), "\nLeft of all at every error.\n"};
text = [text, last{1 + isempty(misses)}];
puts (last{1 + isempty (misses)});
peers_write (fullfile (here, "peers.md"), text);
