## index2.m: the bench of loops in index 2, called by `make bench-index2`. Writes index2.md beside
## itself.
##
## Method radau in both ways of the loops, "projection" and "index2", on the motions of examples
## with loops (tests/octave/example_motion.m) and on a four-bar with a stiff spring: steps, turns
## of Newton's method, calls, least time and the largest error of all states beside their largest
## and usual sizes, against radau at a tolerance of 1e-12.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
addpath (fullfile (root, "tests", "octave"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
for id = {"gsmbp:stiff", "gsmbp:angles", "gsmbp:singular", "gsmbp:margin", "gsmbp:tolerance"}
  warning ("off", id{1});
end

## the motions: words, model, start, times, options
function list = motions (root, out)
  list = {};
  for name = {"slider_crank", "slider_crank_induction", "andrews", "four_bar", "bricard"}
    gsmbp_derive (fullfile (root, "examples", name{1}, [name{1} ".mac"]), out);
    [m, x0, t, options] = example_motion (name{1}, @(name) gsmbp_build (name, "directory", out));
    list(end+1,:) = {name{1}, m, x0, t(t <= 2), options(1:end-2)};
  end
  gsmbp_derive (fullfile (root, "tests", "scenes", "stiff_loop.mac"), out);
  m = gsmbp_build ("stiff_loop", "directory", out);
  x0 = gsmbp_assemble (m, m.initial, "hold", {"q1", "s"});
  for spring = [1e8, 1e9, 1e11; 1e3, 1e5, 1e7]
    list(end+1,:) = {sprintf("four-bar, spring %g N/m, damper %g N s/m", spring), ...
                     gsmbp_set(m, "k", spring(1), "c", spring(2)), x0, 0:0.05:1, {}};
  end
end

## the least seconds of some runs, and the last one
function [r, info, seconds] = timed (m, x0, t, options)
  [seconds, spent] = deal (Inf, 0);
  for k = 1:40
    [r, info] = gsmbp_simulate (m, x0, t, options{:});
    seconds = min (seconds, r.stats.seconds);
    spent += r.stats.seconds;
    if (info != 0 || spent > 0.3)
      break;
    end
  end
end

text = ["# Loops in index 2\n\n" ...
        "| motion | rtol | way | error | steps | failed | turns | calls | ms |\n" ...
        "|---|---|---|---|---|---|---|---|---|\n"];
for motion = motions (root, out)'
  [name, m, x0, t, options] = motion{:};
  exact = gsmbp_simulate (m, x0, t, options{:}, "method", "radau", "rtol", 1e-12).x;
  size = max (abs (exact)) + m.nominal';
  for rtol = 10 .^ -(4:2:10)
    for way = {"projection", "index2"}
      [r, info, seconds] = timed (m, x0, t, [options, {"method", "radau", "loops", way{1}, ...
                                                       "rtol", rtol, "maxsteps", 1e5}]);
      e = Inf;
      if (info == 0)
        e = max (max (abs (r.x - exact) ./ size));
      end
      s = r.stats;
      line = sprintf ("| %s | %.0e | %s | %.1e | %d | %d | %d | %d | %.2f |\n", name, rtol, ...
                      way{1}, e, s.accepted, s.rejected, s.newton, s.calls, 1e3 * seconds);
      puts (line);
      text = [text, line];
    end
  end
end
f = fopen (fullfile (here, "index2.md"), "w");
fputs (f, text);
fclose (f);
