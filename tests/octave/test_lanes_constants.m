## Columns of parameters of runs in lanes: constants of sixteen runs at once (PRE_W; its numbers:
## tests/sh/lanes.sh), the same bits whatever the order, the number of threads and the runs beside;
## rows that PRE refuses; every row is run.

function test_lanes_constants ()
  rods = gsmbp_fixture ("lanes_lengths");
  constants (rods);
  refused (rods);
  all_rows (rods);
  from_pre_w (rods);
  left_behind (rods);
end

## parameters of N runs of the rods, from scattered starts, for a few steps
function [o, t] = rows_of_rods (m, n)
  rand ("twister", 7);
  half = @(k) 2 * rand (n, k) - 1;
  o = {"starts", half(4), "parameters", struct("a2", 0.5 + 0.1 * half (1), ...
       "m2", 1 + 0.2 * half (1), "g", 9.81 + half (1)), "method", "rk4", "step", 5e-3};
  t = [0, 0.01, 0.02];
end

function o = few (o, k)
  o{2} = o{2}(k,:);
  o{4} = structfun (@(x) x(k), o{4}, "UniformOutput", false);
end

function constants (m)
  n = 1000;
  [o, t] = rows_of_rods (m, n);
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  f = gsmbp_ensemble (m, [], t, o{:}, "lanes", false);
  gsmbp_check ("columns of parameters: a thousand runs", e.lanes && all (e.ok));
  gsmbp_check ("as one after the other", e.x - f.x, 1e-12);
  g = gsmbp_ensemble (m, [], t, o{:}, "threads", 2);
  gsmbp_check ("by two threads, bit for bit", equal_runs (g, 1:n, e, 1:n));
  order = randperm (n);
  g = gsmbp_ensemble (m, [], t, few (o, order){:}, "threads", 2);
  gsmbp_check ("in another order, bit for bit", equal_runs (g, 1:n, e, order));
  for k = [1, 16, 17, 500, n]
    g = gsmbp_ensemble (m, [], t, few (o, k){:});
    gsmbp_check (sprintf ("run %d alone, bit for bit", k), g.lanes && equal_runs (g, 1, e, k));
  end
end

## parameters that PRE refuses: a length that is 0, a number that is too large
function refused (m)
  n = 50;
  [o, t] = rows_of_rods (m, n);
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  bad = o;
  bad{4}.a2([3, 50]) = 0;
  bad{4}.g(20) = 1.1e300;
  good = setdiff (1:n, [3, 20, 50]);
  for threads = 1:2
    f = gsmbp_ensemble (m, [], t, bad{:}, "threads", threads);
    says = @(k, text) ! isempty (strfind (f.reason{k}, text));
    gsmbp_check (["refused alone: " f.reason{3} "; " f.reason{20}], ...
                 isequal (find (f.ok)', good) && equal_runs (f, good, e, good) ...
                   && says (3, "a length is 0 by which these equations divide") ...
                   && says (20, "not finite") && all (isnan (f.x(:,:,[3, 20, 50])(:))));
    g = gsmbp_ensemble (m, [], t, bad{:}, "threads", threads, "lanes", false);
    gsmbp_check ("as those that are not in lanes", ...
                 isequal (f.reason, g.reason) && isequaln (f.reached, g.reached));
  end
  f = gsmbp_ensemble (m, [], t, few (bad, 3){:});
  gsmbp_check ("one alone that is refused", ! f.ok && isequal (f.reason, g.reason(3)));
  f = gsmbp_ensemble (m, [], t, few (bad, [3, 50, 20, 3]){:}, "threads", 2);
  gsmbp_check ("nothing but such", ! any (f.ok) && isequal (f.reason, g.reason([3, 50, 20, 3])));
end

## every row is run, by one of the threads, whatever their number and the length of the runs
function all_rows (m)
  [o, t] = rows_of_rods (m, 100);
  o{2}(1:7:end,3:4) *= 30;
  o = [o(1:4), {"method", "dp853", "atol", 1e-9, "rtol", 1e-9}];
  t = [0, 0.5];
  e = gsmbp_ensemble (m, [], t, o{:}, "threads", 1);
  same = e.lanes && all (e.ok);
  for threads = 1:5
    for n = [1:6, 15:18, 31:34, 47, 100]
      f = gsmbp_ensemble (m, [], t, few (o, 1:n){:}, "threads", threads);
      same = same && equal_runs (f, 1:n, e, 1:n);
    end
  end
  gsmbp_check ("one to a hundred runs by one to five threads, bit for bit", same);
end

## a PRE_W with another number shows in the runs in lanes, and in no others
function from_pre_w (m)
  folder = fullfile (getenv ("GSMBP_TEST_DIR"), "fortran_out");
  other = fullfile (folder, "other_pre_w");
  [~, ~] = mkdir (other);
  copyfile (fullfile (folder, "lanes_lengths.json"), other);
  text = fileread (fullfile (folder, "lanes_lengths.f"));
  k = strfind (text, "_PRE_W(")(1);
  f = fopen (fullfile (other, "lanes_lengths.f"), "w");
  fputs (f, [text(1:k), regexprep(text(k+1:end), '(CST\(IS\+K0,\d+\) = )(K\d+)', "$1 1.01D0*$2")]);
  fclose (f);
  changed = gsmbp_build ("lanes_lengths", "directory", other);
  [o, t] = rows_of_rods (m, 20);
  runs = @(m, varargin) gsmbp_ensemble (m, [], t, o{:}, varargin{:}).x;
  gap = @(varargin) max (abs (runs (changed, varargin{:}) - runs (m, varargin{:}))(:));
  gsmbp_check ("constants of lanes are those of PRE_W", gap () > 1e-4);
  gsmbp_check ("others are those of PRE", gap ("lanes", false) == 0);
  gsmbp_build ("lanes_lengths", "directory", folder);   # the module of that name again
end

## "timeout": runs that were begun and others, all are told
function left_behind (m)
  warning ("off", "gsmbp:stopped", "local");
  [o, ~] = rows_of_rods (m, 2000);
  o{end} = 1e-5;
  e = gsmbp_ensemble (m, [], 0:0.05:1, o{:}, "threads", 2, "timeout", 0.5);
  begun = e.calls > 0;
  gsmbp_check (["timeout: " e.reason{end}], ...
               strcmp (e.stopped, "timeout") && e.lanes && any (begun) && ! begun(end) ...
                 && all (e.ok | e.cut) && all (strcmp (e.reason, "") == e.ok) ...
                 && all (strcmp (e.reason(! begun), "not begun: ended by option timeout")) ...
                 && all (e.reached(! begun) == 0));
end
