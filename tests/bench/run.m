## run.m: the benchmark, called by `make bench`. Writes report.md and report.json beside itself,
## figures into out/.
##
## Every system of systems/ (BENCH_SYSTEMS="puma3 puma6": these only) is derived in both modes and
## pass by pass, compiled and timed; its torques and accelerations are compared with the same
## Fortran in quad precision on random and on hard states, and that with Newton-Euler equations of
## its own. PEERS=1: SymPy, CasADi, Pinocchio and MuJoCo from PyPI on the same states in the same
## run; BENCH_CAP: seconds for one of their derivations (60). The steps are the functions of speed/,
## in the order in which they are called here; the bench of the symbols and that of inverse
## kinematics (EAIK beside, with PEERS=1) follow.

1;
## a report of its own, one step down
function text = section (file)
  text = regexprep (fileread (file), "^#", "##", "lineanchors");
end

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"), fullfile (here, "speed"), fullfile (here, "loops"));
out = fullfile (here, "out", "speed");
peers = fullfile (here, "out", "peers");
[~, ~] = mkdir (out);
with_peers = any (strcmp (getenv ("PEERS"), {"1", "yes"}));
cap = str2double (getenv ("BENCH_CAP"));
if (isnan (cap))
  cap = 60;
end
if (with_peers)
  speed_cpu (sprintf ("'%s' '%s'", fullfile (here, "rivals", "setup"), peers));
end

results = skipped = {};
for name = speed_names (here)
  printf ("%s ...\n", name{1});
  try
    s = speed_system (name{1}, out);
    [jobs, s.compile] = speed_build (s, out);
    s.made = [];
    if (with_peers)
      [more, s.made] = speed_rivals (s, peers, cap);
      jobs = [jobs, more];
    end
    s.times = speed_times (s, [jobs, speed_peaks(out)]);
    s.errors = speed_errors (s, jobs, {"random", "fast", "singular"}, 1000);
    results{end+1} = s;
    save ("-binary", fullfile (out, "results.bin"), "results");
  catch problem
    skipped{end+1} = sprintf ("* %s failed: %s", name{1}, ...
                              strjoin (strsplit (problem.message, "\n"), " "));
    disp (skipped{end});
  end
end
results = [results{:}];
bench_save (fullfile (here, "report.json"), speed_json (results));
speed_figures (results, out);
text = [speed_report(results, peers, with_peers), sprintf("%s\n", skipped{:}), ...
        speed_examples(root)];
bench_save (fullfile (here, "report.md"), text);
puts (text);

table = fullfile (here, "out", "symbols.md");
if (system (sprintf ("'%s' '%s'", fullfile (here, "symbols"), table)) != 0)
  error ("bench: tests/bench/symbols failed; report.md is without its tables");
end
text = [text, "\n", section(table)];
bench_save (fullfile (here, "report.md"), text);

setenv ("PEERS", {"", peers}{1 + with_peers});
reach = fullfile (here, "reach", "run");
if (system (sprintf ("'%s' '%s'", reach, fullfile (here, "out", "reach"))) != 0)
  error ("bench: tests/bench/reach failed; report.md is without its table");
end
bench_save (fullfile (here, "report.md"), [text, "\n", section(fullfile (here, "reach.md"))]);
