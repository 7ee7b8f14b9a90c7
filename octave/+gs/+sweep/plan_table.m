## table = gs.sweep.plan_table (who, o, more)
## The samples of a sweep by the options O of gsmbp_sweep (vary, plan, runs, seed): a row each, a
## column for each parameter of O.vary.  MORE: how many numbers of each run are kept beside.

function table = plan_table (who, o, more)
  laws = cellfun (@(name) law (who, name, o.vary.(name)), fieldnames (o.vary)', ...
                  "UniformOutput", false);
  k = numel (laws);
  enough (who, o);
  check_size (who, o, laws, k + more);
  switch (o.plan)
    case {"grid", "corners"}
      ends = cellfun (@(l) l.(o.plan), laws, "UniformOutput", false);
      table = pairings (ends);
      return;
    case "sobol"
      u = gs.sweep.sobol_points (who, o.runs, k);
    case "indices"
      u = arranged (gs.sweep.sobol_points (who, o.runs, 2 * k), k);
    case "random"
      u = by_chance (o.seed, o.runs, k);
    case "latin"
      u = latin (by_chance (o.seed, o.runs, 2 * k), o.runs, k);
  endswitch
  table = zeros (size (u));
  for j = 1:k
    table(:,j) = laws{j}.at (u(:,j));
  endfor
endfunction

## base samples of the plan "indices": with fewer columns of Sobol points, and so parameters, go
## together (of ten parameters: 7 samples have columns that coincide, 31 such that correlate by
## 0.99, 63 by 0.16 at most)
function enough (who, o)
  if (strcmp (o.plan, "indices") && o.runs < 63)
    error (["%s: option runs: expected 63 samples or more for the plan \"indices\", below " ...
            "which columns of Sobol points go together (255 give indices within some 0.04), " ...
            "found %d"], who, o.runs);
  endif
endfunction

## the table in the memory: 1e9 numbers, 8 GB, at the most
function check_size (who, o, laws, width)
  runs = o.runs;
  if (any (strcmp (o.plan, {"grid", "corners"})))
    runs = prod (cellfun (@(l) numel (l.(o.plan)), laws));
  elseif (strcmp (o.plan, "indices"))
    runs *= numel (laws) + 2;
  endif
  if (runs * width > 1e9)
    error (["%s: %g runs with %d numbers each are %.3g numbers; expected 1e9 at the most, " ...
            "which take 8 GB: fewer runs, or less of option keep"], who, runs, width, ...
           runs * width);
  endif
endfunction

## a distribution: its values AT shares of the probability, those of a grid, its ends
function l = law (who, name, given)
  if (isnumeric (given) && ! (isempty (given) || isvector (given)))
    error ("%s: option vary: %s: expected a vector, found a %s matrix", who, name, ...
           sprintf ("%dx", size (given))(1:end-1));
  endif
  numbers = isnumeric (given) && isreal (given) && all (isfinite (given(:)));
  normal = iscell (given) && numel (given) == 3 && strcmp (given{1}, "normal") ...
           && all (cellfun (@(x) isnumeric (x) && isreal (x) && isscalar (x) && isfinite (x), ...
                            given(2:3))) && given{3} > 0;
  if (numbers && numel (given) == 2 && given(1) < given(2))
    l.at = @(u) given(1) + (given(2) - given(1)) * u;
    l.grid = l.corners = given(:);
  elseif (numbers && numel (given) > 2)
    list = given(:);
    l.at = @(u) list(1 + min (floor (u * numel (list)), numel (list) - 1));
    l.grid = list;
    l.corners = [min(list); max(list)];
  elseif (normal)
    [mean_, sigma] = given{2:3};
    l.at = @(u) mean_ - sigma * sqrt (2) * erfcinv (2 * u);
    l.grid = l.corners = mean_ + 3 * sigma * [-1; 1];
  else
    error (["%s: option vary: %s: expected [low, high], a list of more numbers or {\"normal\", " ...
            "mean, standard deviation above 0}, found %s"], who, name, gs.text.shown_value (given));
  endif
endfunction

## all pairings of lists of values, the last one changing first
function table = pairings (lists)
  n = cellfun (@numel, lists);
  index = cell (1, numel (lists));
  [index{:}] = ind2sub (fliplr ([n, 1](1:max (2, numel (n)))), (1:prod (n))');
  table = zeros (prod (n), numel (n));
  if (numel (n) == 1)
    table = lists{1};
    return;
  endif
  for j = 1:numel (n)
    table(:,j) = lists{j}(index{numel (n)+1-j});
  endfor
endfunction

## blocks of 64 rows, each begun by the seed and its number; the generator of the user goes on as
## it was
function u = by_chance (seed, n, k)
  before = rand ("twister");
  guard = onCleanup (@() rand ("twister", before));
  u = zeros (64 * ceil (n / 64), k);
  for b = 1:ceil (n / 64)
    rand ("twister", [seed; b; 64]);
    u(64*b-63:64*b,:) = rand (k, 64)';
  endfor
  u = u(1:n,:);
endfunction

## one sample in each of N slices of every parameter
function u = latin (chance, n, k)
  [~, order] = sort (chance(:,1:k), 1);
  u = (order - 1 + chance(:,k+1:end)) / n;
endfunction

## Saltelli's: A, B, then A with a column of B, one parameter after the other
function u = arranged (both, k)
  [a, b] = deal (both(:,1:k), both(:,k+1:end));
  u = [a; b];
  for j = 1:k
    c = a;
    c(:,j) = b(:,j);
    u = [u; c];
  endfor
endfunction
