## gsmbp_optimize: multipliers against differences of optima, sets of contradictory demands against
## linear programs over all subsets.

function test_optimize_prices ()
  if (! gsmbp_has_nlopt () || ! gsmbp_has_ipopt ())
    printf ("ok left out: libnlopt-dev or coinor-libipopt-dev is not installed\n");
    return;
  end
  m = gsmbp_fixture ("design_lamp");
  prices (m);
  of_a_run (m);
  conflicts (m);
end

## bounds and demands of all relations, of one goal in units of another size
function prices (m)
  level = {"positions", "q", [0; 0.5]};
  at = @(b) solved (m, level, b);
  b = [0.35, 300, 0.5, 3];   # lc <=, k >=, effort at 0 =, mass <
  [r, J] = at (b);
  texts = {"lc < 0.35", "value k > 300", "start effort.q = 0.5", "mass all < 3"};
  loosened = [1, -1, 0, 1];   # 0: an equation, by its bound
  for k = 1:numel (b)
    h = 1e-3 * b(k);
    step = zeros (size (b));
    step(k) = h;
    [~, up] = at (b + step);
    [~, down] = at (b - step);
    slope = (up - down) / (2 * h);
    here = strcmp ({r.active.text}, texts{k});
    expected = merge (loosened(k) == 0, slope, -slope * loosened(k));
    found = [r.active(here).multiplier, NaN](1);
    gsmbp_check (sprintf ("%s: multiplier %.6g, by differences %.6g", texts{k}, found, ...
                          expected), ...
                 abs (found - expected) < 1e-4 * abs (expected));
  end
end

function [r, J] = solved (m, level, b)
  free = {"mc", 1, [0.1 10]; "lc", 0.1, [0.01 b(1)]; "k", 40, [1 1000]; "h", 0.3, [0.05 0.6]};
  demands = {"value", "k", ">", b(2); "start", "effort.q", "=", b(3); "mass", "all", "<", b(4)};
  goal = {"value", "h", 1000; "value", "mc", -400; "value", "k", 1};
  r = gsmbp_optimize (m, free, goal, demands, level, "solver", "slsqp");
  J = r.J;
end

## of a peak over a run
function of_a_run (m)
  run = {"run", (0:0.05:1)', [0.3 0], "input", 0};
  at = @(b) gsmbp_optimize (m, {"d", 3, [0.1 50]; "k", 90, [10 200]}, ...
                            {"value", "d"; "value", "k"}, {"peak", "q_d", "<", b}, run);
  r = at (1.5);
  slope = (at (1.501).J - at (1.499).J) / 0.002;
  k = strncmp ({r.active.text}, "peak q_d", 8);
  gsmbp_check (sprintf ("peak of a run: multiplier %.6g, by differences %.6g", ...
                        r.active(k).multiplier, -slope), ...
               abs (r.active(k).multiplier + slope) < 1e-3 * abs (slope));
end

## random half planes: the set that is told cannot be met, and without any one of it can
function conflicts (m)
  free = {"a", 0, [-3 3]; "b", 0, [-3 3]};
  rand ("state", 7);
  good = count = 0;
  sizes = [];
  do
    A = 2 * rand (6, 2) - 1;
    b = 2 * rand (6, 1) - 1.5;
    if (can (A, b))
      continue;
    end
    count++;
    demands = cell (6, 3);
    for k = 1:6
      demands(k,:) = {@(p) A(k,:) * [p.a; p.b], "<", b(k)};
    end
    [r, info] = gsmbp_optimize (m, free, {"value", "a"}, demands);
    texts = cellfun (@(d, c) sprintf ("%s < %g", func2str (d), c), demands(:,1), ...
                     demands(:,3), "UniformOutput", false);
    told = cellfun (@(t) find (strcmp (t, texts)), r.conflict);
    least = ! can (A(told,:), b(told));
    for k = 1:numel (told)
      less = told([1:k-1, k+1:end]);
      least = least && can (A(less,:), b(less));
    end
    good += info == 2 && least;
    sizes(end+1) = numel (told);
  until (count == 6)
  gsmbp_check (sprintf ("least sets of %s demands that contradict each other, %d of %d", ...
                        strjoin (strsplit (num2str (sizes)), ", "), good, count), good == count);
end

function yes = can (A, b)
  yes = true;
  if (! isempty (b))
    [~, ~, code, extra] = glpk (zeros (2, 1), A, b, [-3; -3], [3; 3], ...
                                repmat ("U", 1, numel (b)), "CC", 1, struct ("msglev", 0));
    yes = code == 0 && any (extra.status == [2, 5]);
  end
end
