## passages.m: the bench of positions where constraints lose rank, called by `make bench-passages`.
## Writes passages.md beside itself.
##
## Ten passages without forces: the four_bar example as a parallelogram, three and ten
## parallelograms in a row, the slider-crank with equal arms; eight tolerances.  Forty first steps
## and forty grids of output times are drawn (SEED, default 1), RUNS pairs of them (default 60;
## 1600: all) run.

here = fileparts (mfilename ("fullpath"));
root = fileparts (fileparts (here));
addpath (fullfile (root, "octave"), fullfile (root, "octave", "hand"), ...
         fullfile (root, "tests", "octave"));
addpath (fullfile (here, "passages"), fullfile (here, "loops"));
out = fullfile (here, "out");
[~, ~] = mkdir (out);
warning ("off", "gsmbp:singular");
number = @(name, default) [str2num(getenv(name)), default](1);
runs = min (1600, number ("RUNS", 60));
seed = number ("SEED", 1);

scenes = {"parallelogram", "the four_bar example", bench_scene("four_bar", out)
          "parallelograms", "three parallelograms", passage_row(root, 3, out)
          "parallelograms", "ten parallelograms", passage_row(root, 10, out)
          "slider-crank", "slider-crank, equal arms", gsmbp_hand("hand_crank")};
rand ("twister", seed);
[first, grid] = meshgrid (1:40, 1:40);
pairs = [first(:), grid(:)](randperm (1600, runs),:);
head = {"scene", "rtol", "median", "worst", "smooth", "limit", "over", "calls, median", "worst", ...
        "loose", "positions", "failed"};
lines = {"# Ten passages of positions where the constraints lose rank", "", ...
         ["Relative change of energy by dp853; calls beside those of an equally long motion " ...
          "without such positions (smooth)."], ...
         "Limit: the larger of 100 times the smooth motion's error and 1e-12 a passage.", ...
         sprintf("%d runs of 40 first steps x 40 output grids, seed %d.", runs, seed), "", ...
         ["| " strjoin(head, " | ") " |"], repmat("|---", 1, numel (head))};
lines{end} = [lines{end} "|"];
for k = 1:rows (scenes)
  s = passage_scene (scenes{k,[1 3]});
  for rtol = 10 .^ -(6:13)
    r = passage_measure (s, rtol, pairs, seed);
    energy = sprintf ("%.1e | ", median (r.energy), max (r.energy), r.smooth, r.limit);
    over = sum (! (r.energy <= r.limit));
    lines{end+1} = sprintf ("| %s | %.0e | %s%d | %.2f | %.2f | %d | %d to %d | %d |", ...
                            scenes{k, ...
                                   2}, rtol, energy, over, median (r.calls), max (r.calls), ...
                                       r.loose, ...
                            min (r.found), max (r.found), numel (r.failed));
    puts ([lines{end} "\n"]);
  end
end
bench_save (fullfile (here, "passages.md"), [strjoin(lines, "\n") "\n"]);
