## Runs that fail, one of many as one alone: trial steps that cannot be made; reasons in the words
## of gsmbp_simulate, of sweeps and their programs, too.

function test_many_failures ()
  addpath (fullfile (fileparts (fileparts (mfilename ("fullpath"))), "bench", "passages"));
  warning ("off", "gsmbp:stiff", "local");
  m = gsmbp_fixture ("many_failures");
  wall (m);
  reasons (m);
  singular ();
  loops (gsmbp_fixture ("driven_fourbar"));
  devices (gsmbp_fixture ("trim_hydraulic"));
  programs (m);
end

## a body comes back from a wall beyond which there is no force: trial steps end there, shorter ones
## do not, in lanes, too; it keeps its energy, but for the errors of some hundred steps close by
function wall (m)
  n = 40;
  table = struct ("q", 10 .^ linspace (-5, -2, n), "edge", repmat (0.3, 1, n));
  energy = @(x) x(:,2) .^ 2 / 2 + 2 * table.q' ./ sqrt (0.3 - x(:,1));
  for rtol = [1e-4, 1e-6, 1e-8]
    for lanes = [false, true]
      e = gsmbp_ensemble (m, [0 1], [0 0.5 1 2], "parameters", table, "lanes", lanes, ...
                          "rtol", rtol, "atol", rtol);
      what = sprintf ("a wall, rtol = %g, %s", rtol, {"one by one", "in lanes"}{1 + lanes});
      gsmbp_check ([what ": all come to their end"], e.lanes == lanes && all (e.ok));
      gsmbp_check ([what ": back with the energy they had"], all (e.final(:,1) < 0) ...
                   && all (abs (energy (e.final) - energy (repmat ([0 1], n, 1))) < 2000 * rtol));
    end
  end
end

## what fails, its parameters, the start, what the reason has, options
function list = causes ()
  list = {"speeds beyond bounds", struct("k", 1), [0 1], " at t = 0.", {}
          "no rates beyond a place", struct("c", 1, "edge", 0.3), [0 1], " at t = 0.28", {}
          "accumulates", struct("floor", -0.1, "g", 10), [0 0], "an event, hit, failed", {}
          "few steps", struct("g", 0.1), [0 1], "maxsteps", {"maxsteps", 2}};
end

function reasons (m)
  for row = causes ()'
    [what, par, x0, word, more] = row{:};
    for method = methods_here ()
      o = [{"method", method{1}, "step", 0.013, "rtol", 1e-9, "atol", 1e-9}, more];
      alone = alone_says (gsmbp_set (m, par), x0, [0 0.5 1 2], o{:});
      two = structfun (@(p) [p, p], par, "UniformOutput", false);
      for lanes = [false, true]
        e = gsmbp_ensemble (m, x0, [0 0.5 1 2], o{:}, "parameters", two, "lanes", lanes);
        gsmbp_check (sprintf ("%s, %s: %s", what, method{1}, e.reason{2}), ! any (e.ok) ...
                     && strcmp (e.reason{2}, alone) && any (strfind (alone, word)));
      end
    end
  end
end

function list = methods_here ()
  list = {"dp853", "rk4", "radau", "gauss", "auto", "cvode"}(1:5 + gsmbp_has_sundials ());
end

## what gsmbp_simulate says, without who says it
function text = alone_says (m, varargin)
  text = gsmbp_complaint (@() gsmbp_simulate (m, varargin{:}));
  text = regexprep (text, '^gsmbp_simulate: [^:]*: ', "");
end

## starts where the constraints lose rank, of links that differ
function singular ()
  s = passage_scene ("parallelogram", gsmbp_hand ("hand_fourbar"));
  g = [0, 9.81, 0];
  x = s.x0;
  x(1:3) += (pi - x(1)) * x(4:6) / x(4);
  for speeds = [0, 1]
    x0 = [x(1:3); speeds * x(4:6)];
    for method = methods_here ()
      o = {"method", method{1}, "rtol", 1e-9, "atol", 1e-9};
      e = gsmbp_ensemble (s.m, x0, [0 0.1], o{:}, "parameters", struct ("g", g));
      for i = 1:3
        alone = alone_says (gsmbp_set (s.m, "g", g(i)), x0, [0 0.1], o{:});
        gsmbp_check (sprintf ("in a dead centre, %s: %s", method{1}, alone), ...
                     strcmp (e.reason{i}, alone) && e.ok(i) == isempty (alone));
      end
    end
  end
end

## a mechanism that comes to the end of its range, in two ways of its loops
function loops (m)
  warning ("off", "gsmbp:singular", "local");
  m = gsmbp_set (m, "la", 0.45);
  x0 = gsmbp_assemble (m, m.initial);
  for way = {"projection", "partitioning"}
    for method = {"dp853", "rk4", "radau"}
      o = {"method", method{1}, "loops", way{1}, "step", 0.01, "rtol", 1e-9, "atol", 1e-9};
      alone = alone_says (gsmbp_set (m, "m1", 1), x0, [0 1 3], o{:});
      e = gsmbp_ensemble (m, x0, [0 1 3], o{:}, "parameters", struct ("m1", [0.9, 1]), "lanes", ...
                          false);
      gsmbp_check (sprintf ("at the end of its range, %s, %s: %s", way{1}, method{1}, alone), ...
                   strcmp (e.reason{2}, alone) && ! isempty (alone) && ! e.ok(2));
    end
  end
end

## a run that fails where a device is outside its margins, one alone, of many, by a program
function devices (m)
  warning ("off", "gsmbp:margin", "local");
  folder = tempname ();
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  name = fieldnames (m.par){1};
  vary = struct (name, m.par.(name) * [1, 1.001]);
  o = {[0.3; 0; -1e6; 5e6], [0 1], "start", "project", "maxsteps", 1, "rtol", 1e-9, "atol", 1e-9};
  alone = alone_says (gsmbp_set (m, name, vary.(name)(2)), o{:});
  e = gsmbp_ensemble (m, o{:}, "parameters", vary);
  p = gsmbp_sweep (m, o{:}, "vary", vary, "plan", "grid", "program", folder);
  file = fullfile (folder, "sweep.h5");
  system (sprintf ("cd / && %s -o %s >/dev/null 2>&1", p.program, file));
  said = cellstr (load ("-hdf5", file).failed.reason);
  gsmbp_check (["outside of its margins: " alone], any (strfind (alone, "outside a margin")) ...
               && strcmp (e.reason{2}, alone) && strcmp (said{2}, alone));
end

## the table of a program says what it knows of it, in the same words
function programs (m)
  folder = tempname ();
  tidy = onCleanup (@() {confirm_recursive_rmdir(false, "local"), rmdir(folder, "s")});
  back = without_mpi ();
  file = fullfile (folder, "sweep.h5");
  for method = {"dp853", "radau", "gauss"}   # make compiles the program anew for each
    for row = causes ()'
      [what, par, x0, ~, more] = row{:};
      o = [{"method", method{1}, "rtol", 1e-9, "atol", 1e-9, "step", 0.013}, more];
      vary = struct ("e", [0.3, 0.31]);
      p = gsmbp_sweep (gsmbp_set (m, par), x0, [0 0.5 1 2], o{:}, "vary", vary, "plan", "grid", ...
                       "program", folder);
      system (sprintf ("cd / && %s -o %s >/dev/null 2>&1", p.program, file));
      said = cellstr (load ("-hdf5", file).failed.reason);
      delete (file);
      w = gsmbp_sweep (gsmbp_set (m, par), x0, [0 0.5 1 2], o{:}, "vary", vary, "plan", "grid");
      of_one = alone_says (gsmbp_set (m, setfield (par, "e", 0.31)), x0, [0 0.5 1 2], o{:});
      gsmbp_check (sprintf ("%s, a sweep by %s: %s", what, method{1}, said{2}), ...
                   strcmp (w.reason{2}, of_one) && numel (said{2}) > 30 ...
                   && strncmp (said{2}, of_one, numel (said{2})));
    end
  end
end
