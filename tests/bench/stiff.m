## stiff.m: the implicit methods beside SUNDIALS, called by `make bench-devices`. Writes stiff.md
## beside itself.
##
## The motion of every example (tests/octave/example_motion.m) by dp853, radau, cvode and by ARKODE
## of SUNDIALS (tests/bench/arkode, its orders 3, 4 and 5, the best one), each at many tolerances:
## the least time within an error. An example is stiff where dp853 says so or where a method of
## SUNDIALS is faster than dp853. STIFF: these only.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
addpath (fullfile (root, "tests", "octave"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
for id = {"gsmbp:stiff", "gsmbp:angles", "gsmbp:singular", "gsmbp:margin", "gsmbp:tolerance", ...
          "Octave:shadowed-function"}
  warning ("off", id{1});
end
for name = {"stewart", "welding_arm", "scara"}
  addpath (fullfile (root, "examples", name{1}));
end

function library = build_arkode (root, out)
  library = fullfile (out, "libgsmbp_arkode.so");
  share = fullfile (root, "share");
  sources = [{fullfile(root, "tests", "bench", "arkode", "gsmbp_arkode.c")}
             glob(fullfile (share, "engine", "host", "implicit", "implicit*.c"))
             glob(fullfile (share, "engine", "core", {"*", "solve/plain"}, "*.c"))]';
  command = sprintf (["%s -std=gnu11 -O2 -march=native -fcx-limited-range -fPIC -shared -I%s " ...
                      "-I%s -o %s %s -lsundials_arkode -lsundials_nvecserial " ...
                      "-lsundials_sunmatrixdense -lsundials_sunlinsoldense -lm"], ...
                     strtrim (mkoctfile ("-p", "CC")), fullfile (share, "engine"), ...
                     fullfile (share, "engine", "core"), library, strjoin (sources, " "));
  [status, text] = system ([command " 2>&1"]);
  if (status != 0)
    error ("bench-devices: %s\n%s", command, text);
  end
end

## the model whose cvode is ARKODE of the order
function m = with_arkode (m, library, order)
  by = m.module;
  m.module = @(what, varargin) in_its_place (by, library, order, what, varargin);
end

function varargout = in_its_place (by, library, order, what, given)
  if (strcmp (what, "sim") && ! isempty (given{14}))
    given{14} = library;
    given{15}(1) = order;
  end
  [varargout{1:nargout}] = by (what, given{:});
end

## error and least seconds of a run; more runs where it is short
function [e, seconds, stiff] = measured (m, x0, t, options, exact, size)
  [e, seconds, stiff] = deal (Inf, Inf, false);
  try
    [r, info] = gsmbp_simulate (m, x0, t, options{:});
  catch
    return;
  end
  if (info != 0)
    return;
  end
  e = max (max (abs (r.x - exact) ./ size));
  stiff = isfinite (r.stats.stiff.time);
  seconds = r.stats.seconds;
  spent = seconds;
  for k = 2:12
    if (spent > 0.25)
      break;
    end
    [r, ~] = gsmbp_simulate (m, x0, t, options{:});
    spent += r.stats.seconds;
    seconds = min (seconds, r.stats.seconds);
  end
end

## rows WAY, error, seconds of an example, and whether dp853 finds it stiff
function [ways, errors, seconds, stiff] = example_ways (name, build, library)
  [m, x0, t, options] = example_motion (name, build);
  options = options(1:end-2);
  exact = [];
  for rtol = [1e-13, 1e-12]
    [r, info] = gsmbp_simulate (m, x0, t, options{:}, "method", "auto", "rtol", rtol, ...
                                "maxsteps", 5e6);
    if (info == 0)
      exact = r.x;
      break;
    end
  end
  size = max (abs (exact)) + m.nominal';
  ways = {"dp853", "radau", "cvode", "arkode"};
  [errors, seconds] = deal (cell (1, 4));
  stiff = false;
  for rtol = 10 .^ -(2:0.5:12.5)
    for k = 1:numel (ways)
      if (any (seconds{k} > 1 & isfinite (seconds{k})))   # smaller tolerances take longer
        continue;
      end
      models = {m};
      if (k == 4)
        models = arrayfun (@(order) with_arkode (m, library, order), 3:5, "UniformOutput", false);
      end
      for one = models
        more = {"method", either(k == 4, "cvode", ways{k}), "rtol", rtol, "maxsteps", 3e5};
        [e, s, says] = measured (one{1}, x0, t, [options, more], exact, size);
        stiff |= says;
        errors{k}(end+1) = e;
        seconds{k}(end+1) = s;
      end
    end
  end
end

## one of two
function x = either (test, x, other)
  if (! test)
    x = other;
  end
end

library = build_arkode (root, out);
build = @(name) gsmbp_build (name, "directory", out);
wanted = strsplit (getenv ("STIFF"), " ");
text = ["# Stiff and not: dp853, radau, cvode, ARKODE\n\nLeast milliseconds within an error, " ...
        "of all states beside their largest and usual sizes; Inf was not reached.\n\n" ...
        "| example | error | dp853 | radau | cvode | ARKODE | cvode : radau | ARKODE : radau | " ...
        "best of ours : best |\n|---|---|---|---|---|---|---|---|---|\n"];
puts (text);
misses = {};
for file = glob (fullfile (root, "examples", "*", "*.mac"))'
  [folder, name] = fileparts (file{1});
  if (! (isempty ([wanted{:}]) || any (strcmp (name, wanted))))
    continue;
  end
  try
    gsmbp_derive (file{1}, out);
    [ways, errors, seconds, stiff] = example_ways (name, build, library);
  catch err
    line = sprintf ("| %s | %s |\n", name, strrep (err.message, "\n", " "));
    puts (line);
    text = [text, line];
    continue;
  end
  for bound = 10 .^ -(3:12)
    ms = cellfun (@(e, s) 1e3 * min ([s(e <= bound), Inf]), errors, seconds);
    if (all (isinf (ms)))
      break;
    end
    ours = min (ms(1:2));
    is_stiff = stiff || min (ms(3:4)) < ms(1);
    if (is_stiff && bound <= 1.01e-8 && (ms(3) < 2 * ours || ms(4) < ours))
      misses{end+1} = sprintf ("%s at %g", name, bound);
    elseif (bound > 0.9e-4 && bound < 1.1e-4 && ours > 1.2 * min (ms))
      misses{end+1} = sprintf ("%s at %g", name, bound);
    end
    line = sprintf ("| %s%s | %.0e | %.3f | %.3f | %.3f | %.3f | %.1f | %.1f | %.2f |\n", name, ...
                    either(is_stiff, ", stiff", ""), bound, ms, ms(3:4) / ms(2), ...
                    ours / min (ms));
    puts (line);
    fflush (stdout);
    text = [text, line];
  end
end
last = sprintf (["\nNot within the measure (stiff: at 1e-8 and below twice as fast as cvode, " ...
                 "faster than ARKODE; at 1e-4 within 1.2 of the best): %s.\n"], ...
                strjoin (misses, ", "));
puts (last);
f = fopen (fullfile (here, "stiff.md"), "w");
fputs (f, [text last]);
fclose (f);
