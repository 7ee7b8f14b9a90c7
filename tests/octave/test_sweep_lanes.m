## Sweeps in lanes: the table of one run after the other but for rounding; in the program of the
## sweep bit for bit the same, from any number of threads, with loops, events, samples, switches in
## time, constants that are made run by run, runs that fail.

function test_sweep_lanes ()
  warning ("off", "gsmbp:stiff", "local");
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  arm = gsmbp_fixture ("batch_arm");
  vary = struct ("m2", [16, 19], "f", [4, 6]);
  x0 = linspace (0.1, 0.5, arm.sizes.nx);
  alike (folder, "arm", arm, {x0, 0:0.1:0.4, "vary", vary, "runs", 45, "input", ...
         zeros(1, arm.sizes.nv), "keep", {["rms " arm.states{1}], ["whole " arm.states{2}]}}, 1e-7);
  alike (folder, "arm, short of steps", arm, {x0, 0:0.1:2, "vary", vary, "runs", 20, "maxsteps", ...
         25}, 1e-7);
  alike (folder, "arm by rk4", arm, {x0, 0:0.1:0.4, "vary", vary, "runs", 20, "method", "rk4", ...
         "step", 2e-3}, 1e-7);
  crank = gsmbp_fixture ("event_crank");
  name = fieldnames (crank.par){1};
  alike (folder, "loops and events", crank, {crank.initial, 0:0.1:1, "vary", struct(name, ...
         crank.par.(name) * [0.9, 1.1]), "runs", 20, "keep", {["final " crank.states{1}], ...
         ["count " crank.events(1).name], ["first " crank.events(1).name]}}, 1e-6);
  ball = gsmbp_fixture ("user_bounce");
  alike (folder, "events of the user", ball, {[1 0], 0:0.5:4, "vary", struct("e", [0.5, 0.9], ...
         "last", [1, 5]), "runs", 40, "keep", {"final y", "count hit", "last top"}}, 1e-7);
  motor = gsmbp_fixture ("rows_motor");
  r = gsmbp_simulate (motor, [0 0 0], [0 10], "input", 9, "method", "auto");
  gsmbp_check ("a run that goes on by radau", strcmp (r.stats.method, "radau"));
  alike (folder, "on by radau", motor, {[0 0 0], 0:0.5:10, "vary", struct("J", [0.05, 0.07], ...
         "turn", [0.5, 1.5]), "runs", 20, "input", 9, "method", "auto", "keep", {"final th", ...
         "first cut"}}, 1e-7);
  drive = gsmbp_fixture ("sampled_drive");
  name = fieldnames (drive.par){1};
  alike (folder, "samples", drive, {[0; 0], 0:0.05:1, "vary", struct(name, drive.par.(name) * ...
         [0.9, 1.1]), "input", 1, "runs", 20}, 1e-7);
  circuit = gsmbp_fixture ("switch_circuit");
  alike (folder, "switches in time", circuit, {[0; 0], 0:0.05:1, "vary", struct("t1", ...
         [0.05, 0.4], "d", [0.01, 0.2]), "runs", 20}, 1e-7);
end

function alike (folder, what, m, given, off)
  place = fullfile (folder, "program");
  files = fullfile (folder, {"octave.h5", "sweep.h5"});
  w = gsmbp_sweep (m, given{:}, "file", files{1}, "threads", 2);
  one = gsmbp_sweep (m, given{:}, "lanes", false);
  gsmbp_check ([what ": the scene has lanes"], any (strcmp (m.subroutines, "rhs_w")));
  gsmbp_check (sprintf ("%s: as one after the other; %d of %d runs failed", what, nnz (! w.ok), ...
                        numel (w.ok)), isequal (w.ok, one.ok) && isequal (said (w), said (one)));
  gsmbp_check ([what ": but for rounding"], beside (w.values, one.values), off);
  p = gsmbp_sweep (m, given{:}, "program", place);
  [code, said] = system (sprintf ("cd / && %s -t 3 -o %s 2>&1", p.program, files{2}));
  gsmbp_check ([what ": the program ends well: " strtrim(strrep (said, folder, ""))], code == 0);
  [a, b] = deal (load ("-hdf5", files{1}), load ("-hdf5", files{2}));
  fields = {"table", "ok", "reached", "names", "units", "description"};
  same = cellfun (@(f) isequaln (a.(f), b.(f)), fields);
  gsmbp_check ([what ": the program's table is that of Octave, bit for bit"], all (same) && ...
               isfield (a, "whole") == isfield (b, "whole") && ...
               (! isfield (a, "whole") || isequaln (a.whole, b.whole)));
  cellfun (@delete, files);
end

## reasons without their times, whose last digits differ
function text = said (w)
  text = regexprep (w.reason, '[0-9.e+-]{5,}', "");
end

## the largest difference beside 1 and more; what is no number is so in both
function d = beside (a, b)
  d = 1 - isequal (isnan (a), isnan (b));
  here = ! isnan (a);
  d = max ([d; abs(a(here) - b(here)) ./ (1 + abs (b(here)))]);
end
