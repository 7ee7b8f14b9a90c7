## Sweeps: plans against what is known of them, the table, statistics against closed forms,
## indices of Sobol of a function whose indices are known, the same table from any threads.

function test_sweep ()
  warning ("off", "gsmbp:sign", "local");
  m = gsmbp_fixture ("sweep_ishigami");
  plans (m);
  table (m);
  indices (m);
  yields (m);
  margins (m);
  late_loops ();
  on_disk (m);
  refused (m);
end

function w = swept (m, varargin)
  w = gsmbp_sweep (m, [1; 0], [0, 0.1], varargin{:});
end

function plans (m)
  three = struct ("a", [0, 1], "c", [0, 1], "e", [0, 1]);
  w = swept (m, "vary", three, "runs", 7);
  ## the points of Joe and Kuo's program behind the first
  known = [0.5 0.5 0.5; 0.75 0.25 0.25; 0.25 0.75 0.75; 0.375 0.375 0.625; 0.875 0.875 0.125; ...
           0.625 0.125 0.875; 0.125 0.625 0.375];
  gsmbp_check ("points of Sobol, three dimensions", w.values(:,1:3) - known, 2e-10);
  many = struct ("a", [0, 1], "b", [0, 1], "c", [0, 1], "d", [0, 1], "e", [0, 1], "k", [1, 2], ...
                 "m", [1, 2]);
  w = swept (m, "vary", many, "runs", 1023);
  u = w.values(:,1:7) - [0 0 0 0 0 1 1];
  cells = sort (floor (u * 1024), 1);
  gsmbp_check ("each of 1024 slices of seven dimensions has one point, but the first", ...
               all (all (cells == (1:1023)')));
  w = swept (m, "vary", many, "runs", 200, "plan", "latin");
  gsmbp_check ("Latin hypercube: one point in each slice", ...
               all (all (sort (floor ((w.values(:,1:7) - [0 0 0 0 0 1 1]) * 200), 1) == (0:199)')));
  again = swept (m, "vary", many, "runs", 200, "plan", "latin", "threads", 3);
  other = swept (m, "vary", many, "runs", 200, "plan", "latin", "seed", 2);
  gsmbp_check ("the same seed and any number of threads: the same table, bit for bit", ...
               isequal (w.values, again.values) && ! isequal (w.values(:,1), other.values(:,1)));
  rand ("twister", 7);
  a = rand ();
  rand ("twister", 7);
  long = swept (m, "vary", many, "runs", 300, "plan", "random");
  gsmbp_check ("the user's generator goes on as it was", isequal (a, rand ()));
  short = swept (m, "vary", many, "runs", 130, "plan", "random");
  gsmbp_check ("a sample is a function of its number", ...
               isequal (short.values(1:130,:), long.values(1:130,:)));
  w = swept (m, "plan", "grid", "vary", struct ("a", [1 2 3], "b", [10 20]));
  gsmbp_check ("grid", isequal (w.values(:,1:2), [1 10; 1 20; 2 10; 2 20; 3 10; 3 20]));
  w = swept (m, "plan", "corners", "vary", struct ("a", [1 5 3], "b", {{"normal", 10, 1}}));
  gsmbp_check ("corners", isequal (w.values(:,1:2), [1 7; 1 13; 5 7; 5 13]));
  w = swept (m, "plan", "corners", "vary", struct ("k", [6, 10], "m", [-1, 3]), "keep", ...
             {"final x1", "min x1"});
  ## x = cos (w t): the stiffer, the lighter, the sooner; masses below zero cannot be
  gsmbp_check (["worst corners by name: " w.corner(1).at_least], numel (w.corner) == 2 ...
                 && strcmp (w.corner(1).at_least, "k high, m high") ...
                 && strcmp (w.corner(1).at_largest, "k low, m high") ...
                 && w.corner(1).least == w.min(1) ...
                 && isequal (w.corner(1).failed, {"k low, m low", "k high, m low"}));
  w = swept (m, "vary", struct ("k", [1 2]), "runs", 1, "keep", {"final x1"});
  gsmbp_check ("one run has a mean, a median, no spread", ...
               w.mean == w.values(2) && isequal (w.quantiles, w.values(2) * [1; 1; 1]) ...
                 && isnan (w.std));
  w = swept (m, "vary", struct ("k", [1 2]), "runs", 3, "keep", {"whole x1"});
  gsmbp_check ("whole runs alone", isempty (w.mean) && isequal (size (w.whole.values), [3 2]));
  w = swept (m, "plan", "grid", "vary", struct ("a", [1 5 3]));
  gsmbp_check ("a grid of one parameter", isequal (w.values(:,1), [1; 5; 3]));
end

## x = cos (w t), w^2 = k/m
function table (m)
  t = linspace (0, 1, 101);
  vary = struct ("k", [6, 10], "m", {{"normal", 2, 0.1}});
  w = gsmbp_sweep (m, [1; 0], t, "vary", vary, "runs", 50, "keep", ...
                   {"final x1", "peak x1_d", "max x1", "min x1", "mean x1", "rms x1"});
  o = sqrt (w.values(:,1) ./ w.values(:,2));
  x = cos (o * t);
  known = [x(:,end), max(abs (o .* sin (o * t)), [], 2), max(x, [], 2), min(x, [], 2), ...
           trapz(t, x, 2), sqrt(trapz (t, x .^ 2, 2))];
  gsmbp_check ("what is kept, against the closed form", w.values(:,3:end) - known, 1e-8);
  gsmbp_check ("names and units", isequal (w.names(1:5), {"k", "m", "final x1", "peak x1_d", ...
                                                "max x1"}) ...
                 && isequal (w.units(1:4), {"N/m", "kg", "m", "m/s"}));
  z = w.values(:,3);
  gsmbp_check ("mean, deviation, median", [w.mean(1) - mean(z), w.std(1) - std(z), ...
                                          w.quantiles(2,1) - median(z)], 1e-14);
  gsmbp_check ("ranks: all that k does to the final place is one way", ...
               w.correlation(1,1) < -0.9 && w.correlation(2,1) > 0);
  w = gsmbp_sweep (m, [1; 0], t, "vary", struct ("m", {{"normal", 2, 0.1}}), "runs", 4095, ...
                   "keep", "final x1");
  gsmbp_check ("a normal distribution: mean and deviation", ...
               [mean(w.values(:,1)) - 2, std(w.values(:,1)) / 0.1 - 1], 2e-3);
end

## S = 0.3139, 0.4424, 0; T = 0.5576, 0.4424, 0.2437 (a = 7, b = 0.1)
function indices (m)
  vary = struct ("a", [-pi, pi], "c", [-pi, pi], "e", [-pi, pi]);
  w = swept (m, "vary", vary, "plan", "indices", "runs", 4095);
  [first, total] = ishigami (7, 0.1);
  gsmbp_check ("Ishigami: indices of first order", w.first - first, 0.01);
  gsmbp_check ("Ishigami: total indices", w.total - total, 0.01);
  gsmbp_check ("Ishigami: mean", w.mean - 3.5, 0.02);
end

function [first, total] = ishigami (a, b)
  v1 = (1 + b * pi ^ 4 / 5) ^ 2 / 2;
  v2 = a ^ 2 / 8;
  v13 = b ^ 2 * pi ^ 8 * (1 / 18 - 1 / 50);
  all_ = v1 + v2 + v13;
  first = [v1; v2; 0] / all_;
  total = [v1 + v13; v2; v13] / all_;
end

function yields (m)
  w = swept (m, "vary", struct ("a", [0, 1]), "runs", 1023, "demand", ...
             {"a", 0.25, Inf; "final ishigami", -Inf, Inf});
  gsmbp_check ("yield: three quarters", w.yield - 0.75, 2e-3);
  w = swept (m, "vary", struct ("m", [-1, 3]), "runs", 255, "demand", {"m", -Inf, Inf});
  gsmbp_check (["masses that cannot be fail alone: " w.reason{find(! w.ok, 1)}], ...
               w.yield == mean (w.ok) && abs (w.yield - 0.75) < 0.01 ...
                 && all (isnan (w.values(! w.ok,2))) && isfinite (w.mean));
end

## gains K of a mass 1 on a mass m: L = (K1 + K2 s) / (m s^2)
function margins (m)
  if (isempty (pkg ("list", "control")))
    return;
  end
  pkg load control
  plant = @(mass, sense) ss ([0 1; 0 0], [0; sense / mass], eye (2), 0);
  c = gsmbp_control (plant (1, 1), [], "lqr", "Q", [1 0], "R", 1);
  loop = @(m) on_plant (c, plant (m.par.m, 1));
  o = {"vary", struct("m", [0.5, 3]), "runs", 7, "keep", {"phase_margin", "final x1", ...
       "delay_margin", "Ms"}, "loop", loop, "demand", {"Ms", 0, 1.1; "phase_margin", pi / 3, pi}};
  w = swept (m, o{:});
  mass = w.values(:,1);
  x = (2 + sqrt (4 + 4 * mass .^ 2)) ./ (2 * mass .^ 2);   # K1 = 1, K2^2 = 2
  phase = atan (sqrt (2 * x));
  gsmbp_check ("margins of the loop of each run: the phase [rad]", w.values(:,2) - phase, 1e-8);
  gsmbp_check ("... the delay that it bears [s]", w.values(:,4) - phase ./ sqrt (x), 1e-8);
  gsmbp_check ("... their units", isequal (w.units(2:5), {"rad", "m", "s", "1"}));
  gsmbp_check ("... in demands", w.yield - mean (w.values(:,5) <= 1.1 & phase >= pi / 3), 1e-12);
  file = [tempname() ".h5"];
  tidy = onCleanup (@() delete (file));
  disk = swept (m, o{:}, "file", file, "chunk", 3);
  gsmbp_check ("... on disk", isequal (disk.values, w.values));
  c.D *= 2;   # the same words with another controller
  o{8} = @(m) on_plant (c, plant (m.par.m, 1));
  said = gsmbp_complaint (@() swept (m, o{:}, "file", file, "resume", true));
  gsmbp_check ("... another loop is another sweep", ! isempty (strfind (said, "another sweep")));
  w = swept (m, o{1:6}, "loop", @(m) on_plant (c, plant (m.par.m, sign (m.par.m - 1))));
  gsmbp_check ("a run whose loop is unstable failed, and says it", ...
               all (w.ok == (w.values(:,1) > 1)) ...
               && ! isempty (strfind (w.reason{find(! w.ok, 1)}, "loop: the loop is unstable")));
end

function late_loops ()
  if (isempty (pkg ("list", "control")))
    return;
  end
  m = gsmbp_fixture ("sweep_ishigami");
  c = gsmbp_control (ss ([0 1; 0 0], [0; 1], eye (2), 0), [], "lqr", "Q", [1 0], "R", 1, ...
                     "period", 0.1);
  ## a PI controller of a lag that it cancels: L = K exp (-0.4 s) / s bears pi/2/K
  p = gsmbp_pid (tf (2, [1.5, 1]), [], "pi", "pm", 60, "Ti", 1.5, "delay", 0.4);
  for row = {c, 20, "a pole at |z| = 1.75"; p, 6, "it bears a delay of 0.2 s"}'
    [law, factor, said] = row{:};
    grown = @(m) louder (law, 1 + m.par.a * (factor - 1));
    w = swept (m, "vary", struct ("a", [0, 1]), "plan", "grid", "keep", {"delay_margin"}, ...
               "loop", grown);
    gsmbp_check (["unstable by samples or a delay: " said], isequal (w.ok, [true; false]) ...
                 && ! isempty (strfind (w.reason{2}, said)));
  end
  gsmbp_check ("the delay that is left", p.margins.delay - 0.8, 1e-9);
end

function c = louder (c, factor)
  c.C *= factor;
  c.D *= factor;
end

function c = on_plant (c, plant)
  c.plant = plant;
end

function on_disk (m)
  folder = tempname ();
  mkdir (folder);
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  file = fullfile (folder, "a.h5");
  t = [0, 0.05, 0.1];
  o = {"runs", 100, "vary", struct("a", [0, 1], "m", [-1, 3]), "keep", ...
       {"mean x1", "whole x1", "at 0.05 x1", "final x1"}};
  run = @(varargin) gsmbp_sweep (m, [1; 0], t, o{:}, varargin{:});
  plain = run ("chunk", 100);
  w = run ("file", file, "threads", 2, "chunk", 7);
  names = {"names", "units", "values", "ok", "reason", "reached", "mean", "yield"};
  same = @(a, b) all (cellfun (@(f) isequaln (a.(f), b.(f)), names));
  gsmbp_check ("chunks on disk: the same table and reasons, bit for bit", same (w, plain));
  s = load ("-hdf5", file);
  gsmbp_check ("the file has them", isequaln (s.table', w.values) ...
                 && isequaln (s.whole.x1', plain.whole.values) && isequal (s.times(:)', t) ...
                 && isequal (cellstr (s.units)', w.units) && isequal (double (s.ok(:)), w.ok) ...
                 && isequal (double (s.failed.run(:)), find (! w.ok)) ...
                 && isequal (cellstr (s.failed.reason), w.reason(! w.ok)));
  gsmbp_check ("at a time: that of the whole run", isequaln (w.values(:,4), s.whole.x1(2,:)'));
  gsmbp_check ("nothing else is left", numel (dir (folder)) == 3);
  gsmbp_check ("a finished file is read", same (run ("file", file, "resume", true), plain));
  bytes = fileread (file);
  number = char (typecast (w.values(50,3), "uint8"));
  f = fopen (file, "w");
  fwrite (f, strrep (bytes, number, number([8, 7, 3, 4, 5, 6, 2, 1])));
  fclose (f);
  said = gsmbp_complaint (@() run ("file", file, "resume", true));
  gsmbp_check (["one that is changed is not: " said], numel (strfind (bytes, number)) == 1 ...
               && ! isempty (strfind (said, "a.h5 is damaged: not all of it has its checksum")));
  delete (file);
  run ("file", file, "chunk", 33);
  gsmbp_check ("the same sweep, the same bytes of the file", strcmp (bytes, fileread (file)));
  delete (file);
  warning ("off", "gsmbp:stopped", "local");
  w = run ("file", file, "timeout", 1e-9);
  gsmbp_check (["out of time: what was not made is no result: " w.reason{1}], ...
               strcmp (w.stopped, "timeout") && ! any (w.ok) && isnan (w.yield) ...
                 && ! exist (file, "file") && exist ([file ".parts"], "dir"));
  out_of_time (m, fullfile (folder, "b.h5"));
  w = run ("file", file, "resume", true);
  gsmbp_check ("it goes on, the same table", same (w, plain) && isempty (w.stopped));
  of_another (run, file, {"seed", 2; "plan", "latin"; "rtol", 1e-7});
end

## of the chunk that time ends the runs that were made are kept, in memory and on disk
function out_of_time (m, file)
  slow = @(varargin) gsmbp_sweep (m, [1; 0], 0:0.1:20, "vary", struct ("m", [1, 3]), "keep", ...
                                  "final x1", "chunk", 1e5, varargin{:});
  w = slow ("runs", 4e4, "timeout", 0.6, "file", file);
  k = find (w.ok);
  gsmbp_check (sprintf ("%d runs were made in the time", numel (k)), strcmp (w.stopped, ...
               "timeout") && numel (k) > 0 && numel (k) < 4e4);
  k = k(k <= 300);
  again = slow ("runs", 300);
  gsmbp_check ("they are those of a whole sweep", isequal (w.values(k,:), again.values(k,:)));
  more = slow ("runs", 4e4, "timeout", 0.4, "file", file, "resume", true);
  gsmbp_check (sprintf ("they stay on disk, then %d", nnz (more.ok)), all (more.ok(k)) ...
                 && nnz (more.ok) > nnz (w.ok) && isequal (more.values(w.ok,:), w.values(w.ok,:)));
  part = glob (fullfile ([file ".parts"], "000000000000_*.part")){1};
  f = fopen (part, "r+");
  at = 48 + 2 * 8 + 3;   # in the value of the first run, after the head
  fseek (f, at, "bof");
  byte = fread (f, 1);
  fseek (f, at, "bof");
  fwrite (f, 255 - byte);
  fclose (f);
  whole = slow ("runs", 4e4, "file", file, "resume", true);
  gsmbp_check ("a part that is damaged is made again", all (whole.ok) ...
                 && isequal (whole.values(k,:), again.values(k,:)));
end

function of_another (run, file, others)
  for k = 1:rows (others)
    said = "";
    try
      run ("file", file, "resume", true, others{k,:});
    catch err
      said = err.message;
    end
    gsmbp_check (["another sweep is refused: " strrep(said, fileparts (file), "")], ...
                 ! isempty (strfind (said, "is of another sweep: there ")) ...
                   && ! isempty (strfind (said, others{k,1})));
  end
end

function refused (m)
  one = {"vary", struct("a", [0, 1])};
  wrong = {{}, "option vary is missing: expected a struct";
           {"vary", []}, "option vary: expected a struct";
           {"vary", struct()}, "for each parameter, found a struct without fields";
           {"vary", struct("a", 1)}, "option vary: a: expected [low, high]";
           {"vary", struct("a", [2, 1])}, "option vary: a: expected [low, high]";
           {"vary", struct("a", {{"normal", 1, 0}})}, "option vary: a: expected";
           {"vary", struct("A", [0, 1])}, "unknown parameter \"A\", did you mean \"a\"";
           [one, {"plan", "sobl"}], "option plan";
           [one, {"runs", 0}], "option runs: expected a whole number above 0";
           [one, {"keep", {"least x1"}}], "option keep: expected one of final, peak";
           [one, {"keep", {"last x1"}}], "option keep: unknown event \"x1\"";
           [one, {"keep", {"last x1"}}], "\"x1\" is a quantity: write \"final x1\"";
           [one, {"keep", {"final x2"}}], "option keep: unknown \"x2\", did you mean";
           [one, {"demand", {"b", 0, 1}}], "option demand: unknown \"b\"";
           [one, {"keep", {"at 0.05 x1"}}], "one of the times and a name behind \"at\"";
           [one, {"file", ""}], "option file: expected a name, found an empty text";
           [one, {"plan", "grid", "runs", 7}], "whose runs follow from option vary";
           [one, {"method", "rk5"}], "option method: expected one of";
           [one, {"maxorder", 5}], "option maxorder: method dp853 has one order alone";
           [one, {"chunk", 0}], "option chunk: expected a whole number above 0";
           [one, {"keep", {"Ms"}}], "option loop, a function of the model that gives";
           [one, {"loop", 3}], "option loop: expected a function of the model";
           [one, {"keep", {"Ms"}, "loop", @(m) 1}], "expected that it gives a controller";
           [one, {"keep", {"Ms"}, "loop", @(m) m.nothing}], "at the parameters of the model: ";
           [one, {"keep", {"Ms"}, "loop", @(m) 1, "program", tempname()}], ...
           "expected none in option";
           [one, {"resume", true}], "option resume goes on with";
           [one, {"file", tempdir()}], "is a folder";
           [one, {"runz", 3}], "unknown option \"runz\", did you mean \"runs\""};
  for i = 1:rows (wrong)
    said = "";
    try
      swept (m, wrong{i,1}{:});
    catch err
      said = err.message;
    end
    gsmbp_check (["refused: " said], strncmp (said, "gsmbp_sweep: ", 13) ...
                   && ! isempty (strfind (said, wrong{i,2})));
  end
end
