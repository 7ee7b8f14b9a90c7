## [steps, grids] = passage_draw (LAST, SEED): forty first steps [s] and forty grids of output times
## from 0 to LAST [s], 2 to 200 of them, half of the grids even.

function [steps, grids] = passage_draw (last, seed)
  before = rand ("twister");
  rand ("twister", seed);
  steps = last / 400 * exp (3.5 * rand (1, 40));
  for k = 40:-1:1
    n = floor (200 * rand () ^ 2);
    inner = sort (rand (1, n));
    if (mod (k, 2))
      inner = (1:n) / (n + 1);
    end
    grids{k} = unique ([0, last * inner, last]);
  end
  rand ("twister", before);
end
