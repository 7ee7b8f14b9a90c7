## What many runs refuse: nothing is made on disk before everything is checked, folders and tables
## of others stay as they are, matrices are no lists, too few runs give no indices; what they warn
## of.

function test_sweep_refused ()
  m = gsmbp_hand ("motor_pendulum");
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  nothing_left (m, folder);
  folders (m, folder);
  no_folder (m, folder);
  values (m);
  samples (gsmbp_fixture ("sweep_ishigami"));
  failures (gsmbp_fixture ("sweep_ishigami"));
  in_parts (gsmbp_fixture ("event_ball"), gsmbp_fixture ("sampled_drive"));
end

function told (what, f, word)
  said = gsmbp_complaint (f);
  gsmbp_check ([what ": " regexprep(said, '/[^ ]*/', "")], ! isempty (strfind (said, word)) ...
               && isempty (strfind (said, "\n")));
end

## the folder of a file is not made without being asked for
function no_folder (m, folder)
  place = fullfile (folder, "not", "there");
  told ("a file in a folder that does not exist", ...
        @() gsmbp_sweep (m, [0.1 0 0], [0 0.1], "vary", struct ("m", [1, 1.2]), "runs", 3, ...
                         "file", fullfile (place, "a.h5")), "found no folder");
  gsmbp_check ("... which is not made", ! exist (fileparts (place), "dir"));
end

## wrong arguments, with "file" and with "program"
function nothing_left (m, folder)
  one = {"vary", struct("m", [1, 1.2]), "runs", 3};
  x = [0.1 0 0];
  t = [0 0.1];
  wrong = {[NaN 0 0], t, {}, "argument x0(1), q is not finite: NaN"
           [0 0], t, {}, "argument x0: expected 3 numbers"
           x, t, {"input", [1 2]}, "input: expected 1 finite numbers"
           x, t, {"method", "rk4", "step", 0}, "option step: expected a finite number above 0"
           x, t, {"method", 4}, "option method: expected one of"
           x, t, {"rtol", 2}, "option rtol: expected a number above 0"
           x, t, {"atol", [1 2]}, "option atol: expected one number or 3"
           x, t, {"modes", 1}, "option modes: "
           x, t, {"loops", "svt"}, "option loops must be one of"
           x, t, {"breaks", [0 NaN]}, "option breaks: expected a vector of finite numbers"
           x, t, {"memory", 1}, "option memory: "
           x, t, {"audit", 1}, "option audit is for one run alone"
           x, t, {"input", @(t, x) 1}, "option input: expected constants"
           x, 0, {}, "the times must be two or more"
           x, t, {"keep", {"whole q", "final q", "whole q"}}, "\"whole q\" is given twice"
           x, t, {"keep", {"final q", "final q"}}, "\"final q\" is given twice"};
  for row = wrong'
    [x0, times, more, word] = row{:};
    for place = {{}, {"file", fullfile(folder, "a.h5")}, {"program", fullfile(folder, "p")}}
      told ("refused", @() gsmbp_sweep (m, x0, times, one{:}, more{:}, place{1}{:}), ...
            ["gsmbp_sweep: " {"", "option keep: "}{1 + any(strcmp (more, "keep"))} word]);
    end
    gsmbp_check ("... and nothing is left", numel (dir (folder)) == 2);
  end
end

## where a program may go
function folders (m, folder)
  place = fullfile (folder, "own");
  mkdir (place);
  own = fullfile (place, "Makefile");
  spit (own, "mine\n");
  sweep = @(varargin) gsmbp_sweep (m, [0.1 0 0], [0 0.1], "vary", struct ("m", [1, 1.2]), ...
                                   "runs", 3, varargin{:});
  into = "option program: expected a folder that is empty, new or of a sweep, found ";
  told ("a folder of others", @() sweep ("program", place), into);
  spit (fullfile (place, "sweep.job"), "#!/bin/sh\n");
  told ("with a job of others", @() sweep ("program", place), into);
  gsmbp_check ("... which stays as it was", strcmp (fileread (own), "mine\n") ...
               && numel (dir (place)) == 4);
  told ("a file", @() sweep ("program", own), "option program: ");
  place = fullfile (folder, "program");
  mkdir (place);
  p = sweep ("program", place);
  gsmbp_check ("an empty folder, and that of a sweep, are taken", ...
               ! isempty (sweep ("program", place).program));
  job = fileread (fullfile (place, "sweep.job"));
  table = fullfile (place, "sweep.h5");
  for k = 1:2
    if (k == 1)
      warning ("off", "gsmbp:stopped", "local");
      sweep ("file", table, "timeout", 1e-9);   # it leaves its chunks
    else
      sweep ("file", table, "resume", true);
    end
    sweep ("program", place);
    told ("with runs of another sweep", @() sweep ("program", place, "input", 1), ...
          "is of another sweep: there no option input, here `option input: 1`");
    gsmbp_check ("... whose program stays", ...
                 strcmp (fileread (fullfile (place, "sweep.job")), job));
  end
  spit (table, "no table");
  told ("what is no table", @() sweep ("program", place), "is no table of a sweep");
end

function spit (file, text)
  f = fopen (file, "w");
  fputs (f, text);
  fclose (f);
end

## values that are none, and what is found
function values (m)
  sweep = @(vary, varargin) gsmbp_sweep (m, [0 0 0], [0 0.1], "vary", vary, varargin{:});
  many = @(varargin) gsmbp_ensemble (m, [0 0 0], [0 0.1], varargin{:});
  one = @(t, varargin) gsmbp_simulate (m, [0 0 0], t, varargin{:});
  matrix = "m: expected a vector, found a 2x2 matrix";
  cases = {@() many("parameters", struct ("m", [1 2; 3 4])), matrix
           @() sweep(struct ("m", [1 2; 3 4])), matrix
           @() sweep(struct ("m", {{"gauss", 1, 2}})), "found {\"gauss\", 1, 2}"
           @() sweep(struct ("m", {{"normal", 1, -2}})), "above 0}, found {\"normal\", 1, -2}"
           @() sweep(struct ("m", {{"normal", 1}})), "found {\"normal\", 1}"
           @() sweep(struct ("m", [1 2]), "keep", {"least q"}), "Ms, state_margin and a number, f"
           @() many("starts", [0 0 0; 0 NaN 0]), ...
           "option starts: expected finite numbers, found [0 NaN 0] in row 2"
           @() many("inputs", [1; Inf]), "inputs: expected finite numbers, found Inf in row 2"
           @() one([0 NaN 1]), "vector of finite numbers, found NaN as number 2"
           @() one([0 1; 2 3]), "vector of finite numbers, found a 2x2 matrix"
           @() one([]), "vector of finite numbers, found none"
           @() one("ab"), "argument times: expected no text, found \"ab\""
           @() one([0 1], "breaks", [0.1 0.2; 0.3 0.4]), ...
           "option breaks: expected a vector of finite numbers, found [0.1 0.2;0.3 0.4]"
           @() sweep(struct ("m", [1 2]), "demand", 3), "lower and upper limit, found 3"
           @() one([0 1], "gain", [1 0 0], "reference", [0 0 0], "limits", NaN), ...
           "option limits: expected real numbers, found NaN"
           @() one([0 1], "gain", [1 0], "reference", [0 0 0]), "polynomial, found [1 0]"
           @() gsmbp_plan("table", [0 1], [1 NaN]), ...
           "expected finite numbers, found NaN in row 1, column 2"
           @() gsmbp_plan("table", [0 1], [1 2], 2), "must be 0, 1 or 3, found 2"
           @() gsmbp_plan("profile", 3), "a piecewise polynomial, as of mkpp, found 3"
           @() gsmbp_plan("profile", mkpp ([0 1], 1), 4), "or 3 (jerk), found 4"
           @() gsmbp_plot("a.png", [0 1], 3), "names, label, found 3"
           @() one([0 1], "atol", ones (3, 1, 2)), "option atol: expected one number or 3 numbers"};
  for row = cases'
    told ("a value that is none", row{:});
  end
end

## modes, memory, inputs of which devices have a part
function in_parts (ball, drive)
  told ("modes", @() gsmbp_simulate (ball, ball.initial, [0 1], "modes", [1 0 1 0]), ...
        "each -1, 0 or 1, found [1 0 1 0]");
  told ("memory", @() gsmbp_simulate (drive, [0 0], [0 1], "memory", 1:7), ...
        "finite numbers, found a double of size 1x7");
  told ("an input", @() gsmbp_simulate (drive, [0 0], [0 1], "input", NaN), "\"user\", found NaN");
end

## the plan "indices"
function samples (m)
  vary = struct ("a", [-pi, pi], "c", [-pi, pi], "e", [-pi, pi]);
  sweep = @(n) gsmbp_sweep (m, [1; 0], [0, 0.1], "vary", vary, "plan", "indices", "runs", n);
  least = "option runs: expected 63 samples or more for the plan \"indices\"";
  for n = [1, 2, 7, 62]
    told ("too few samples", @() sweep (n), least);
  end
  w = sweep (63);
  gsmbp_check ("as few as there may be", ! any (isnan ([w.first; w.total])));
  w = sweep (255);   # 0.3139, 0.4424, 0; 0.5576, 0.4424, 0.2437
  gsmbp_check ("some more: first order", w.first - [0.3139; 0.4424; 0], 0.05);
  gsmbp_check ("some more: total", w.total - [0.5576; 0.4424; 0.2437], 0.05);
  lastwarn ("");
  warning ("off", "gsmbp:sign", "local");
  w = gsmbp_sweep (m, [1; 0], [0, 0.1], "vary", struct ("m", [-1, 40], "a", [0, 3]), "plan", ...
                   "indices", "runs", 127);
  [text, id] = lastwarn ();
  n = 127 - nnz (all (reshape (w.ok, 127, 4), 2));
  gsmbp_check (["left out: " text], strcmp (id, "gsmbp:indices") && n > 0 ...
               && ! isnan (w.total(2)) ...
               && ! isempty (strfind (text, sprintf ("without %d of 127 base samples", n))));
  w = gsmbp_sweep (m, [1; 0], [0, 0.1], "vary", struct ("m", [-1, 1], "a", [0, 3]), "plan", ...
                   "indices", "runs", 63);
  gsmbp_check ("too few are left", all (isnan ([w.first; w.total])));
end

## all runs failed
function failures (m)
  warning ("off", "gsmbp:sign", "local");
  o = {"vary", struct("m", [-2, -1]), "runs", 150};
  for n = {"sweep", "ensemble"}
    lastwarn ("");
    if (strcmp (n{1}, "sweep"))
      said = evalc (["w = gsmbp_sweep (m, [1; 0], [0, 0.1], o{:});" ...
                     "fflush (stderr);"]);
      runs = 150;
    else
      e = gsmbp_ensemble (m, [1; 0], [0, 0.1], "parameters", struct ("m", [-1, -2]));
      runs = 2;
    end
    [text, id] = lastwarn ();
    gsmbp_check (["all failed: " text], strcmp (id, "gsmbp:failed") && strncmp (text, ...
                 ["gsmbp_" n{1} ": "], 10) && ! isempty (strfind (text, sprintf ( ...
                 ["sweep_ishigami: all %d runs failed, run 1: link sledge: mass must not be " ...
                  "negative"], runs))));
  end
  for n = 2:3
    lastwarn ("");
    gsmbp_ensemble (m, [1; 0], [0, 0.1], "parameters", struct ("m", [2, -1, 2](1:n)));
    [text, id] = lastwarn ();
    wanted = {["gsmbp_ensemble: sweep_ishigami: 1 of 2 runs failed, the first of them run 2: " ...
               "link sledge: mass must not be negative; found: m = -1"], ""}{n-1};
    gsmbp_check (sprintf ("one of %d: %s", n, text), strcmp (text, wanted) ...
                                                     && strcmp (id, {"gsmbp:failed", ""}{n-1}));
  end
  for kind = {"scatter", "tornado", "indices"}
    told ("no figure of them", @() gsmbp_sweep_plot ("a.png", w, kind{1}), ...
          "gsmbp_sweep_plot: expected a run that came to its end and has final ishigami");
  end
end
