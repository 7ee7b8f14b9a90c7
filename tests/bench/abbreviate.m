## abbreviate.m: the bench of gsmbp_abbreviate, called by `make bench-abbreviate`. Writes
## abbreviate.md beside itself.
##
## The PUMA 560 of Armstrong, Khatib and Burdick, three and six links, speeds to 1.5 rad/s and
## accelerations to 5 rad/s^2, every pose: operations, time of a call and error of the whole model
## and of those with the terms that matter to 0.1, 1 and 5 % of each effort. Errors: on states other
## than those of the derivation.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"));
out = fullfile (here, "out", "abbreviate");
[~, ~] = mkdir (fullfile (here, "out"));
systems = sprintf ('"%s/systems/puma3.mac", "%s/systems/puma6.mac"', here, here);
log = fullfile (here, "out", "abbreviate.log");
[status, text] = ...
    system (sprintf (["GSMBP_TIMEOUT=1800 %s/share/make/maxima %s " ...
                      "'load(\"%s/gsmbp/gsmbp.mac\")$ load(\"%s/abbreviate.mac\")$ " ...
                      "abbreviate_all([%s], [0.001, 0.01, 0.05], \"%s\")$' 2>&1"],
  root, log, root, here, systems, out));
if (status != 0)
  error ("abbreviate: %s", text);
end

## states within the ranges, every second one with speeds and accelerations at their ends; n rows
function [q, u, ud] = states (n, K)
  [q, u, ud] = deal (pi * (2 * rand (n, K) - 1), 1.5 * (2 * rand (n, K) - 1), ...
                     5 * (2 * rand (n, K) - 1));
  u(:, 1:2:end) = 1.5 * sign (u(:, 1:2:end));
  ud(:, 1:2:end) = 5 * sign (ud(:, 1:2:end));
end

## seconds of one call of each of two models, in turn: the least of twenty
function best = times_of (models, name, varargin)
  t = zeros (20, 2);
  for k = 1:20
    for i = 1:2
      t(k,i) = models{i}.module ("time", 40000, name, models{i}.cst, varargin{:});
    end
  end
  best = 1e9 * min (t);
end

rand ("twister", 9);
lines = regexp (fileread (log), 'ABBREVIATED (\S+) (\S+) (\S+) +(\d+) +(\d+) +(\S+) +(\S+)', ...
                "tokens");
rows = {};
K = 10000;
for k = 1:numel (lines)
  l = lines{k};
  word = tolower (l{3});
  if (! any (strcmp (word, {"inv", "fwd"})))
    continue
  end
  [name, place] = deal (strrep (l{1}, "_less", ""), l{2});
  [whole, less] = deal (gsmbp_build (name, "directory", out), ...
                        gsmbp_build (l{1}, "directory", place));
  n = whole.sizes.nu;
  [q, u, ud] = states (n, K);
  [a, b] = deal (zeros (n, K));
  for i = 1:K
    a(:,i) = whole.inv (0, q(:,i), u(:,i), ud(:,i));
    if (strcmp (word, "inv"))
      b(:,i) = less.inv (0, q(:,i), u(:,i), ud(:,i));
    else
      b(:,i) = less.mas (0, q(:,i)) * ud(:,i) + less.bia (0, q(:,i), u(:,i));
    end
  end
  e = max (max (abs (a - b), [], 2) ./ max (abs (a), [], 2));
  given = {0, q(:,1), u(:,1), ud(:,1)};
  if (strcmp (word, "fwd"))
    given = {0, q(:,1), u(:,1), [], a(:,1)};
  end
  t = times_of ({whole, less}, word, given{:});
  bound = "";
  if (strcmp (word, "inv"))
    bound = sprintf ("%.2f %%", 100 * str2double (l{7}));
  end
  tolerance = sprintf ("%g %%", str2double (regexp (place, '[^/]+$', "match"){1}) / 10);
  rows{end+1} = sprintf ("| %s | %s | %s | %s | %s | %.1f | %.1f | %.3f %% | %s |", name, l{3}, ...
                         tolerance, l{4}, l{5}, t, 100 * e, bound);
  printf ("%s\n", rows{end});
end
f = fopen (fullfile (here, "abbreviate.md"), "w");
fprintf (f, ...
         ["# The PUMA with the terms that matter\n\nEvery pose, speeds to 1.5 rad/s, " ...
          "accelerations to 5 rad/s^2; error: largest of 10000 states, over the " ...
          "largest effort of its row (FWD: of M*UD + BIA).\n\n"]);
fprintf (f, ...
         ["| scene | routine | tolerance | operations | left | ns a call | of the " ...
          "shorter | error | bound by intervals " ...
          "|\n|---|---|---|---|---|---|---|---|---|\n"]);
fprintf (f, "%s\n", rows{:});
fclose (f);
