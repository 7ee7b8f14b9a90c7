## The program of a sweep, Fortran and C without Octave: its table is, bit for bit, that of Octave,
## with loops, events, samples, implicit methods, rules that are broken, runs that fail, from any
## number of threads; it goes on with what Octave began, and Octave with what it began.

function test_sweep_program ()
  warning ("off", "gsmbp:stiff", "local");
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  axis = gsmbp_hand ("motor_pendulum");
  vary = struct ("m", [-0.2, 1.2], "l", {{"normal", 0.5, 0.01}});
  keep = {"rms q", "at 0.1 q", "whole drive.i", "min q_d", "mean drive.i", "peak q", "max q"};
  same (folder, "axis", axis, {[0.1 0 0], 0:0.1:0.5, "vary", vary, "input", 3, "keep", keep, ...
                               "plan", "random", "runs", 60});
  few = {[0.1 0 0], 0:0.1:1, "vary", struct("m", [1, 1.2]), "runs", 5};
  same (folder, "short of steps", axis, [few, {"maxsteps", 12}]);
  for method = {"rk4", "gauss", "radau", "auto"}
    step = {{}, {"step", 1e-3}}{1 + any(strcmp (method{1}, {"rk4", "gauss"}))};
    same (folder, method{1}, axis, [few, {"input", 3, "method", method{1}}, step]);
  end
  plan = gsmbp_plan ("septic", [0 1], [0.1 1]);
  table = gsmbp_plan ("table", [0 0.5 1], [0 5 7], 0);
  feedback = {"gain", [400, 10, 0], "reference", [0.5; 0; 0], "limits", 12, "breaks", 0.35};
  same (folder, "a planned motion", axis, [few, {"motion", plan}]);
  same (folder, "inputs of a table", axis, [few, {"input", table, "maxstep", 0.05}]);
  same (folder, "a feedback with limits", axis, [few, feedback]);
  same (folder, "radau, an order, tolerances", axis, [few, {"method", "radau", "maxorder", 5, ...
        "rtol", 1e-7, "atol", [1e-8, 1e-7, 1e-6]}]);
  if (gsmbp_has_sundials ())
    same (folder, "cvode", axis, [few, {"input", 3, "method", "cvode"}]);
  end
  crank = gsmbp_fixture ("case_02a_motor");
  x0 = gsmbp_assemble (crank, [0.3; -0.1; 0; zeros(4, 1)]);
  same (folder, "loops", crank, {x0, 0:0.1:0.5, "vary", struct("La", [0.02, 0.03], "l2", ...
        crank.par.l2 * [1, 1 + 1e-4]), "runs", 9, "input", 5});
  same (folder, "loops in index 2", crank, {x0, 0:0.1:0.5, "vary", struct("La", [0.02, 0.03]), ...
        "runs", 5, "input", 5, "method", "radau", "loops", "index2"});
  rods = struct ("l2", crank.par.l2 * [1, 1.01]);
  for way = {"baumgarte", "check"; "partitioning", "project"}'
    same (folder, ["loops by " way{1}], crank, {x0, 0:0.1:0.3, "vary", rods, "runs", 5, "input", ...
          5, "method", "radau", "loops", way{1}, "start", way{2}});
  end
  drive = gsmbp_fixture ("sampled_drive");
  name = fieldnames (drive.par){1};
  same (folder, "samples", drive, {[0; 0], 0:0.05:1, "vary", struct(name, drive.par.(name) * ...
        [0.9, 1.1]), "input", 1, "runs", 9});
  circuit = gsmbp_fixture ("switch_circuit");
  for method = {"dp853", "radau"}
    same (folder, ["times at which it switches by " method{1}], circuit, ...
          {[0; 0], 0:0.05:1, "vary", struct("t1", [0.05, 0.4], "d", [0.01, 0.2]), "runs", 9, ...
           "method", method{1}, "keep", {"whole shown", "at 0.1 shown", "final A.u"}});
  end
  same (folder, "starts beyond a stop", gsmbp_fixture ("stop_far"), {[0.5; 0], 0:0.1:1, "plan", ...
        "grid", "vary", struct("top", [0.4, 0.6, 1e6])});
  ball = gsmbp_fixture ("event_ball");
  [name, hit] = deal (fieldnames (ball.par){1}, ball.events(1).name);
  for method = {"dp853", "radau"}
    same (folder, ["events by " method{1}], ball, {ball.initial, 0:0.05:1, "vary", struct(name, ...
          ball.par.(name) * [0.9, 1.1]), "runs", 9, "method", method{1}, "keep", ...
          {["final " ball.states{1}], ["first " hit], ["last " hit], ["count " hit]}});
  end
  too_sharp (folder, gsmbp_fixture ("event_pulled"));
  refused (axis, few, folder);
  another (axis, few, folder);
end

## friction that falls too steeply for radau: a run fails, and says the same
function too_sharp (folder, m)
  warning ("off", "gsmbp:events", "local");
  given = {[0 0], 0:0.1:3, "vary", struct("vs", [1e-3, 1e-10, 1e-2]), "plan", "grid", "method", ...
           "radau", "atol", 1e-12};
  same (folder, "events that are none", m, given);
  w = gsmbp_sweep (m, given{:});
  gsmbp_check (["... " w.reason{2}], ! isempty (strfind (w.reason{2}, "INFO = 9 at t = 0.735")) ...
               && ! isempty (strfind (w.reason{2}, "does friction fall within a speed vs")));
end

## a table that is there must be that of the sweep
function another (m, few, folder)
  file = fullfile (folder, "table.h5");
  p = gsmbp_sweep (m, few{:}, "program", fullfile (folder, "one"));
  q = gsmbp_sweep (m, few{:}, "seed", 7, "plan", "random", "program", fullfile (folder, "two"));
  run_it = @(w) system (sprintf ("%s -o %s 2>&1", w.program, file));
  [codes(1), ~] = run_it (p);
  [codes(2), said] = run_it (p);
  gsmbp_check ("a table that is there is not made again", all (codes == 0) && ...
               ! isempty (strfind (said, "table.h5 is there")));
  [code, said] = run_it (q);
  gsmbp_check (["... of another sweep: " strtrim(strrep (said, folder, ""))], code != 0 && ...
               ! isempty (strfind (said, "table.h5 is of another sweep: delete it")));
  f = fopen (file, "r+");
  number = char (typecast (load ("-hdf5", file).table(end), "uint8"));
  at = strfind (fread (f, Inf, "char=>char")', number);
  fseek (f, at(1), "bof");
  fwrite (f, 7);
  fclose (f);
  [code, said] = run_it (p);
  gsmbp_check ("... a damaged one", code != 0 && ! isempty (strfind (said, "table.h5 is damaged")));
  damaged_job (p, folder);
end

## a job that is cut short in a record or between two, or that has bytes after its end
function damaged_job (p, folder)
  [job, file] = deal (fullfile (folder, "one", "sweep.job"), fullfile (folder, "none.h5"));
  bytes = fileread (job);
  n = numel (bytes) - numel (sprintf ("end s 0\n\n"));
  for row = {"cut in a record", "cut between two", "with bytes after its end", "empty"
             bytes(1:n-3), bytes(1:n), [bytes "more"], ""}
    f = fopen (job, "w");
    fwrite (f, row{2});
    fclose (f);
    [code, said] = system (sprintf ("%s -o %s 2>&1", p.program, file));
    gsmbp_check (["a job " row{1} ": " strtrim(strrep (said, folder, ""))], code != 0 ...
                 && ! isempty (strfind (said, "sweep.job: it is cut short")) && ! exist (file));
  end
end

function same (folder, what, m, given)
  place = fullfile (folder, "program");
  files = fullfile (folder, {"octave.h5", "sweep.h5"});
  w = gsmbp_sweep (m, given{:}, "file", files{1});
  p = gsmbp_sweep (m, given{:}, "program", place);
  [code, said] = system (sprintf ("cd / && %s -t 3 -o %s 2>&1", p.program, files{2}));
  gsmbp_check ([what ": the program ends well: " strtrim(strrep (said, folder, ""))], code == 0);
  [a, b] = deal (load ("-hdf5", files{1}), load ("-hdf5", files{2}));
  fields = {"table", "ok", "reached", "names", "units", "description"};
  alike = cellfun (@(f) isequaln (a.(f), b.(f)), fields);
  if (isfield (a, "whole"))
    alike(end+1) = isequaln (a.whole, b.whole);
  end
  if (isfield (a, "failed"))
    alike(end+1) = isequal (a.failed.run, b.failed.run) && reasons (a, b);
  end
  gsmbp_check (sprintf ("%s: the table of Octave, bit for bit; %d of %d runs failed", what, ...
                        nnz (! w.ok), numel (w.ok)), all (alike));
  r = gsmbp_sweep (m, given{:}, "file", files{2}, "resume", true);
  gsmbp_check ([what ": Octave takes it for its own"], isequaln (r.values, w.values));
  cellfun (@delete, files);
end

## what Octave adds to a reason, the program does not know
function is = reasons (a, b)
  [a, b] = deal (cellstr (a.failed.reason), cellstr (b.failed.reason));
  is = all (cellfun (@(x, y) strncmp (x, y, numel (y)) && ! isempty (y), a, b));
end

function refused (m, few, folder)
  wrong = {{"input", @(t, x) 1}, "found a function of Octave"
           {"audit", 1}, "option audit is for one run alone"};
  for k = 1:rows (wrong)
    said = "";
    try
      gsmbp_sweep (m, few{:}, wrong{k,1}{:}, "program", folder);
    catch err
      said = err.message;
    end
    gsmbp_check (["refused: " said], ! isempty (strfind (said, wrong{k,2})));
  end
end
